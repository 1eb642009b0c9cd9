#pragma once

/// @file The reference control software of a soccer robot KS21: from sensor frame to command frame.
///
/// Each control period: posture from the joint sensors, odometry from the stance foot, percepts from the pictures and
/// sights (if there are any), self-localisation and ball, decision, body and head motion, radio message, report. A
/// robot that lies or gets up looks at no picture and trusts no odometry; back on its feet it knows that it is
/// somewhere near.

#include <memory>

#include "behaviour.h"
#include "body_motion.h"
#include "camera_past.h"
#include "course_memory.h"
#include "head_motion.h"
#include "murosimf/control/client/control_software.h"
#include "obstacle_memory.h"
#include "percept_source.h"
#include "world_model.h"

namespace murosimf::controllers {

class Player final : public client::ControlSoftware {
 public:
  explicit Player(std::unique_ptr<PerceptSource> eyes) : eyes_(std::move(eyes)) {}

  /// @throws std::invalid_argument for a robot that is no KS21
  void start(const client::RobotDescription& robot) override;
  void step(const client::SensorFrame& sensors, client::CommandFrame& commands) override;
  const client::ControlReport& report() const override { return report_; }
  void archive(client::StateArchive& archive) override;

 private:
  void feelMotion(const client::SensorFrame& sensors);
  void heedReferee(const client::GameInfo& game, double time);
  void expectLate(const client::SensorFrame& sensors);
  void look(const client::SensorFrame& sensors);
  void getBackOnFeet();
  std::size_t collectObstacles(const PlanarPose& X_FR);
  Situation gather(const client::SensorFrame& sensors);
  void moveJoints(const client::SensorFrame& sensors, const Play& play, client::CommandFrame& commands);
  client::TeamMessage message(const Play& play) const;
  void fillReport(const Play& play);

  client::RobotDescription robot_;
  Role role_ = Role::kStriker;
  int wing_ = 0;
  std::unique_ptr<PerceptSource> eyes_;

  Posture posture_;
  bool posture_known_ = false;
  bool servos_feel_ = false;  ///< some joint has reported a torque: soles can tip, so balance is worth the effort
  std::uint32_t restart_count_ = 0;
  CameraPast past_;
  Percepts percepts_;
  Localisation localisation_;
  BallModel ball_;
  TeamBall team_ball_;
  ObstacleMemory obstacles_;
  CourseMemory course_;
  std::vector<Point> obstacles_R_;  ///< of this step: robots seen, team mates, goal posts, a course's obstacles

  Behaviour behaviour_;
  BodyMotion body_;
  HeadMotion head_;
  client::ControlReport report_;
};

/// The player with its eyes: it plays with pictures, with sights of level "oracle", or with both.
std::unique_ptr<client::ControlSoftware> makePlayer();

}  // namespace murosimf::controllers
