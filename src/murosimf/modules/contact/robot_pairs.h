#pragma once

/// @file Where robots touch one another and what stands on the field.
///
/// Two of which neither recoils have nothing to find here: kinematic robots are kept apart by blocking_phase.h.
/// Broad phase   robots and posts by the discs that they can reach (neighbour_list.h); then their bodies by bounding
///               spheres, and by how far they have gone since they were found apart (near_shapes.h). Bodies of one
///               robot where rules say that they touch, and its joints give way.
/// Narrow phase  algorithms/collision/detect_contact.h, up to four points a pair of shapes.
/// Cost          some ns a robot with nobody near; 1 us two robots that stand side by side; the narrow phase
///               besides.

#include <functional>

#include "murosimf/algorithms/collision/detect_contact.h"
#include "murosimf/algorithms/neighbour_list.h"
#include "murosimf/linking/batch.h"
#include "murosimf/modules/contact/contact_robots.h"
#include "murosimf/modules/contact/near_shapes.h"

namespace murosimf {

class RobotPairs {
 public:
  RobotPairs() = default;
  /// Agrees in the table on all that robots may touch here; the table must live longer.
  /// @throws std::invalid_argument naming both surfaces when nothing says how they touch
  RobotPairs(ContactTable& table, const ContactRobots& robots, const std::vector<FixedObstacle>& fixed);

  /// Told of every partner that was added to the frame: its object and the robot's number, -1 for what is fixed.
  using NamePartner = std::function<void(ObjectId object, int robot)>;
  /// Adds pairs and partners of what overlaps at the frame's start.
  /// @param kept contacts of the last frame
  void find(ContactRobots& robots, const std::vector<FixedObstacle>& fixed, std::span<const KeptContact> kept,
            FrameContacts& frame, const NamePartner& name_partner);
  /// For which there is room without allocation.
  std::size_t mostContacts() const { return most_contacts_; }

  /// Of the last frame.
  struct Counts {
    long robots = 0;  ///< pairs of robots near enough to look at their bodies
    long listed = 0;  ///< pairs of shapes that may touch soon
    long tested = 0;  ///< pairs of shapes that may touch, so that one looked at their surfaces
    long found = 0;   ///< points
  };
  const Counts& counts() const { return counts_; }

 private:
  struct Side {
    int robot = -1;  ///< -1: something fixed
    const Obstacle* shape = nullptr;
    ObjectId object;
    std::uint64_t name = 0;
    Pose X_WB;
  };
  void fetch(const std::pair<int, int>& robots) const;
  void betweenRobots(int a, int b);
  void listDiscs();
  void withOthers();
  void withFixed(int robot, const FixedObstacle& obstacle);
  void withItself(int robot);
  ContactRobot& robotOf(int robot) { return robots_->wake(static_cast<std::size_t>(robot)); }
  const PlacedShapes& placedOf(int robot);
  const ShapeTravel& travelOf(int robot);
  Side sideOf(int robot, std::size_t shape) const;
  double test(const Side& a, const Side& b, const ContactTerms& terms);
  Vector3 lastNormal(const ContactKey& key) const;
  void addPoint(const Side& a, const Side& b, const ContactTerms& terms, const ContactPoint& point,
                const Vector3& normal, int points);
  int partnerOf(const Side& side);

  const ContactTable* table_ = nullptr;
  std::vector<char> touches_itself_;  // of each robot
  std::vector<PlacedShapes> placed_;  // as robots
  std::vector<ShapeTravel> travels_;  // same
  AlignedDoubles travelled_;          // what these keep
  std::vector<ShapeTravel::Way> ways_;
  NearShapes near_;
  std::vector<PlaneDisc> discs_;                 // of robots, then of what is fixed
  NeighbourList neighbours_;                     // of these
  std::vector<std::pair<int, int>> near_fixed_;  // robots and what is fixed, of the frame
  std::size_t most_contacts_ = 0;
  Counts counts_;
  long frame_number_ = -1;
  // Of the call of find().
  ContactRobots* robots_ = nullptr;
  const std::vector<FixedObstacle>* fixed_ = nullptr;
  std::span<const KeptContact> kept_;
  FrameContacts* frame_ = nullptr;
  const NamePartner* name_partner_ = nullptr;
};

}  // namespace murosimf
