// A robot's description in CBOR: keys are the names of the structs' members.

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "murosimf/control/player_api/surroundings.h"

namespace murosimf {

// The library's macros look for these functions beside the types.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Vector3, x, y, z)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rotation3, x, y, z)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pose, rotation, translation)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlanarPose, x, y, heading)

namespace client {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointDescription, name, lower, upper, largest_velocity, largest_torque)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CameraDescription, name, width, height, fx, fy, cx, cy, skew, kc, body, X_BC, period,
                                   lens, linear_from)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WheelDescription, name, joint, centre, axle, radius, rollers, roller_angle)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RangeSensorDescription, name, body, X_BS, angles, half_angle, least, largest, period)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TouchSensorDescription, name, body, centre, threshold)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FieldDescription, length, width, goal_width, goal_height, goal_depth, post_radius,
                                   line_width, border, centre_circle_radius, goal_area_length, goal_area_width,
                                   penalty_area_length, penalty_area_width, penalty_mark_distance, ball_radius,
                                   pole_radius, pole_height)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CourseDescription, length, width, X_FC, first_passed_on_left, slalom,
                                   obstacle_radius, obstacle_spacing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DeviceDescription, kind, name, part, corner, scale, offset, lowest, highest)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RobotDescription, model, team, number, role, joints, cameras, soles, imus,
                                   touch_sensors, force_sensors, touch_mounts, range_sensors, wheels, devices, field,
                                   course, attacks_positive_x, goal_colour_attacked, goal_colour_defended,
                                   control_period, paced, seed)

}  // namespace client

namespace player_api {

std::string describeInCbor(const client::RobotDescription& robot) {
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(nlohmann::json(robot));
  return {bytes.begin(), bytes.end()};
}

client::RobotDescription descriptionFromCbor(const std::string& cbor) {
  try {
    return nlohmann::json::from_cbor(cbor).get<client::RobotDescription>();
  } catch (const nlohmann::json::exception& problem) {
    throw std::runtime_error(std::string("the robot's description cannot be read: ") + problem.what());
  }
}

}  // namespace player_api

}  // namespace murosimf
