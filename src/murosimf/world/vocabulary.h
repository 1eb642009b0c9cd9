#pragma once

/// @file The shared words: properties in which modules, readers and builders meet.
///
/// Frames: W the field (origin at its centre, z up), B the base body of a robot, S a sole (centre of its lower face).

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/algorithms/centroidal_motion.h"
#include "murosimf/algorithms/collision/convex_hull.h"
#include "murosimf/algorithms/corner_forces.h"
#include "murosimf/algorithms/ray_scene.h"
#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/touch_response.h"
#include "murosimf/algorithms/tree_table.h"
#include "murosimf/math/spatial.h"
#include "murosimf/world/contact_rules.h"
#include "murosimf/world/property.h"

namespace murosimf {

/// A place on a row of a robot's tree table.
struct MountPlace {
  int row = 0;
  Pose X_RM;  ///< mount frame M on the row's body
  friend bool operator==(const MountPlace&, const MountPlace&) = default;
};

/// The rectangle on which a foot stands; X_RM is the frame at the centre of its lower face.
struct SolePlace {
  MountPlace mount;
  double half_length = 0, half_width = 0;  ///< along x and y [m]
  friend bool operator==(const SolePlace&, const SolePlace&) = default;
};

/// Which way a wheel lets its contact point slide: none, along the axles of its rollers only, or all but freely.
enum class WheelKind : std::uint8_t { kPlain, kRollers, kCastor };

/// A wheel, which a joint turns about its axle, or a castor: a ball that slides.
struct WheelPlace {
  WheelKind kind = WheelKind::kPlain;
  int row = 0;              ///< body that it is; that of a wheel is turned by joint row - 1
  Vector3 centre;           ///< p_RC [m]
  Vector3 axle{0, 1, 0};    ///< of length 1, the axis of the joint: turning about it drives towards axle x up
  double radius = 0;        ///< [m]
  double roller_angle = 0;  ///< from the way that it drives to its lowest roller's axle, positive about up [rad]
  friend bool operator==(const WheelPlace&, const WheelPlace&) = default;
};

/// Directions in which a range sensor looks, in its frame S: x forward, z up.
struct RangeModel {
  bool nearest = false;             ///< one reading, the least of all directions; else a reading each
  std::vector<Vector3> directions;  ///< of length 1
  double least = 0, largest = 0;    ///< that it can tell [m]
  int readings() const { return nearest ? 1 : static_cast<int>(directions.size()); }
  friend bool operator==(const RangeModel&, const RangeModel&) = default;
};

/// One shape of a body: what touches and what is seen.
struct PlacedShape {
  int row = 0;  ///< body (row of the tree table) that carries it; 0 for single bodies
  Pose X_BS;    ///< shape on the body
  Shape shape;
  Colour colour;
  std::string surface;  ///< surface type, for the table of surface pairs
  bool collides = true, drawn = true;
  int touch_sensor = -1;                               ///< that feels it, counted in the robot's; -1: none
  std::shared_ptr<const ConvexHull> hull = nullptr;    ///< of a kConvex shape, in S; one for all robots of a file
  std::shared_ptr<const TriangleMesh> mesh = nullptr;  ///< drawn in the shape's place, in S; shared likewise
  int wheel = -1;                                      ///< that it is, counted in the robot's; -1: none
  friend bool operator==(const PlacedShape&, const PlacedShape&) = default;
};

/// Demand of a joint: tau = kp (position - q) + kd (velocity - dq) + torque. A position servo takes position, and
/// velocity as its speed limit where that is positive; with kp = 0 it keeps its position.
struct ServoCommand {
  double position = 0, velocity = 0, torque = 0, kp = 0, kd = 0;
};

/// How an integrator moves in a step: what whoever pushes from outside must know of it.
struct StepManner {
  double end_velocity_share = 0.5;  ///< the position moves by h ((1 - s) v + s v+)
  double held_turn = 0.5;           ///< a force held in a body's axes has turned by this share of the step's turn
};

/// Ten numbers that robots of one batch may differ in.
template <>
inline constexpr bool kIsNumeric<RigidInertia<double>> = true;

// Constants of robots.
inline constexpr Constant<TreeTable> kTree{"tree", "", "kinematic tree of bodies and joints"};
inline constexpr Constant<std::vector<SolePlace>> kSoles{"soles", "", "places of the soles, right ones first"};
inline constexpr Constant<MountPlace> kImuPlace{"imu_place", "", "mount of the inertial measurement unit"};
inline constexpr Constant<std::vector<PlacedShape>> kShapes{"shapes", "", "shapes of all bodies"};
inline constexpr Constant<std::vector<ContactTerms>> kGroundTerms{
    "ground_terms", "", "of each shape with the ground, where rules speak of it"};
inline constexpr Constant<std::vector<std::pair<int, int>>> kIgnoredPairs{
    "ignored_pairs", "", "rows of bodies that never touch each other, smaller first, ascending"};
inline constexpr Constant<double> kLowerLimit{"lower_limit", "rad", "smallest joint position"};
inline constexpr Constant<double> kUpperLimit{"upper_limit", "rad", "largest joint position"};
inline constexpr Constant<double> kLargestVelocity{"largest_velocity", "rad/s", "no-load speed of the servo"};
inline constexpr Constant<double> kInitialPosition{"initial_position", "rad", "joint position at the start"};
inline constexpr Constant<RigidInertia<double>> kBodyInertia{
    "body_inertia", "SI", "mass, mass times centre of mass, inertia about the origin"};
inline constexpr Constant<double> kStallTorque{"stall_torque", "N m", "of the servo, at rest"};
inline constexpr Constant<double> kServoStiffness{"servo_kp", "N m/rad", "torque per error of position"};
inline constexpr Constant<double> kServoDamping{"servo_kd", "N m s/rad", "torque per velocity"};
inline constexpr Constant<double> kArmature{"armature", "kg m^2", "rotor inertia seen at the joint"};
inline constexpr Constant<double> kJointDamping{"joint_damping", "N m s/rad", "viscous friction of the joint"};
inline constexpr Constant<double> kJointFriction{"joint_friction", "N m", "dry friction of the joint"};
inline constexpr Constant<double> kEncoderResolution{"encoder_resolution", "rad", "step of the servo's own angle"};
inline constexpr Constant<double> kBacklash{"backlash", "rad", "play between the servo and its joint"};
inline constexpr Constant<double> kBlockingRadius{"blocking_radius", "m",
                                                  "radius of the upright cylinder that kinematic robots keep clear of"};
inline constexpr Constant<double> kTouchThreshold{"touch_threshold", "N", "force above which a touch sensor closes"};
inline constexpr Constant<MountPlace> kForcePlace{"force_place", "", "mount of a force sensor, on what it carries"};
inline constexpr Constant<std::vector<WheelPlace>> kWheels{"wheels", "", "places of wheels and castors"};
inline constexpr Constant<double> kWheelFriction{"wheel_friction", "1",
                                                 "mu of a wheel or castor on the ground: largest force over load"};
inline constexpr Constant<double> kWheelStickSpeed{"wheel_stick_speed", "m/s",
                                                   "slip of a wheel at rest at which its friction is used up"};
inline constexpr Constant<double> kWheelCreepage{"wheel_creepage", "1",
                                                 "further slip over rolling speed at which its friction is used up"};
inline constexpr Constant<double> kNoiseKey{"noise_key", "1",
                                            "whole number below 2^53 from which its random numbers follow"};
// Constants of single bodies.
inline constexpr Constant<double> kMass{"mass", "kg", "m > 0"};
inline constexpr Constant<double> kInertiaFactor{"inertia_factor", "1", "beta of a ball: I = beta m r^2"};
inline constexpr Constant<Pose> kFixedPose{"fixed_pose", "", "X_WB of a body that never moves"};

inline constexpr Constant<double> kBallRadius{"ball_radius", "m",
                                              "radius of the sphere with which a free body touches"};
// Constants of cameras.
inline constexpr Constant<CameraModel> kCameraModel{"camera_model", "", "lens and size of the picture"};
inline constexpr Constant<MountPlace> kCameraPlace{"camera_place", "", "mount; C: x right, y down, z forward"};
inline constexpr Constant<std::vector<int>> kHiddenRows{"hidden_rows", "", "bodies that this camera does not draw"};
// Constants of range sensors.
inline constexpr Constant<RangeModel> kRangeModel{"range_model", "", "directions and limits of a range sensor"};
inline constexpr Constant<MountPlace> kRangePlace{"range_place", "", "mount of a range sensor; S: x forward, z up"};
inline constexpr Constant<double> kRangePeriod{"range_period", "s", "time between two scans"};
inline constexpr Constant<double> kRangePhase{"range_phase", "s", "time of the first scan"};
inline constexpr Constant<double> kRangeOffset{"range_offset", "m", "added to every reading"};
inline constexpr Constant<double> kRangeBias{"range_bias", "m", "deviation of what else is added, drawn once a sensor"};
inline constexpr Constant<double> kRangeNoise{"range_noise", "m", "deviation of the noise of each reading"};
inline constexpr Constant<double> kRangeNoiseShare{"range_noise_share", "1",
                                                   "deviation of further noise, over the range that is read"};
inline constexpr Constant<double> kRangeQuantum{"range_quantum", "m", "step of readings; 0: none"};
inline constexpr Constant<double> kRangeDelay{"range_delay", "s", "from a scan to its reading"};
// Constants of the world's root.
inline constexpr std::string_view kGroundSurface = "turf";  ///< surface type of the ground
inline constexpr Constant<SurfaceTable> kSurfaceTable{"surface_table", "", "what happens between types of surface"};
inline constexpr Constant<std::vector<ContactRule>> kContactRules{"contact_rules", "", "where it is otherwise"};
inline constexpr Constant<PaintedGround> kGround{"ground", "", "carpet and painted lines"};

// Variables that come from outside the modules.
inline constexpr Variable<ServoCommand> kJointCommand{"joint_command", "SI", "demand in force, from the robot port"};
inline constexpr Variable<PlanarPose> kPlacement{"placement", "m, rad", "where somebody last put the robot"};
inline constexpr Variable<double> kPlacementCount{"placement_count", "1", "how often somebody has put the robot"};
inline constexpr Variable<Vector3> kPlanarShift{"planar_shift", "m", "displacement that keeps robots apart, next step"};

// Variables of motion.
inline constexpr Variable<double> kJointPosition{"joint_position", "rad", "q at the end of the step"};
inline constexpr Variable<double> kJointVelocity{"joint_velocity", "rad/s", "mean rate of q over the step"};
inline constexpr Variable<Pose> kBasePose{"base_pose", "m", "X_WB at the end of the step"};
inline constexpr Variable<Pose> kBasePoseLast{"base_pose_last", "m", "X_WB at the beginning of the step"};
inline constexpr Variable<Pose> kBodyPose{"body_pose", "m", "X_WB of each body at the end of the step",
                                          Storage::kOnDemand};
inline constexpr Variable<Pose> kBodyPoseLast{"body_pose_last", "m", "X_WB of each body at the beginning of the step",
                                              Storage::kOnDemand};
inline constexpr Variable<Pose> kShownBase{"shown_base", "m", "body_pose of the base", Storage::kKept};
inline constexpr Variable<Pose> kShownBaseLast{"shown_base_last", "m", "body_pose_last of the base", Storage::kKept};
inline constexpr Variable<double> kShownPosition{"shown_position", "rad", "q in body_pose", Storage::kKept};
inline constexpr Variable<double> kShownPositionLast{"shown_position_last", "rad", "q in body_pose_last",
                                                     Storage::kKept};
inline constexpr Variable<double> kPlacementsShown{"placements_shown", "1", "placement_count of body_pose; -1: of none",
                                                   Storage::kKept};
inline constexpr Variable<SpatialMotion<double>> kBaseVelocity{"base_velocity", "SI",
                                                               "w and v of the base's origin, base axes"};
inline constexpr Variable<Vector3> kBodyVelocity{"body_velocity", "m/s", "v_WB of a free body's centre"};
inline constexpr Variable<Vector3> kBodyRate{"body_rate", "rad/s", "w_WB of a free body, world axes"};
inline constexpr Variable<double> kSoleClearance{"sole_clearance", "m", "height of the sole's lowest corner",
                                                 Storage::kKept};
inline constexpr Variable<double> kStanceSide{"stance_side", "1", "foot that carries the robot: 0 right, 1 left"};
inline constexpr Variable<double> kSupportSlip{"support_slip", "m/s", "speed of the other foot while it touches too",
                                               Storage::kKept};
inline constexpr Variable<double> kFlattenedTurn{"flattened_turn", "rad",
                                                 "taken away at the last exchange of feet or level", Storage::kKept};
inline constexpr Variable<double> kFlattenedShift{"flattened_shift", "m", "same", Storage::kKept};
inline constexpr Variable<double> kFlight{"flight", "1", "1 when the pinned foot would have to be pulled to the ground",
                                          Storage::kKept};

inline constexpr Variable<ServoCommand> kServoDemand{"servo_demand", "SI",
                                                     "what a servo's electronics ask of its motor"};
inline constexpr Variable<double> kJointRateDemand{"joint_rate_demand", "rad/s",
                                                   "joint velocity that a servo holds over the step"};
inline constexpr Variable<double> kMeasuredTorque{"measured_torque", "N m", "of servo, friction and stops",
                                                  Storage::kKept};
inline constexpr Variable<double> kServoLoad{"servo_load", "1", "size of the servo's torque over stall_torque",
                                             Storage::kKept};

// Variables that live while an integrator evaluates forces; everything of a body in its own axes, about its origin.
inline constexpr Variable<SinCos<double>> kJointTurn{"joint_turn", "1", "sine and cosine of q; sliding: q [m] and 1",
                                                     Storage::kStep};
inline constexpr Variable<SpatialMotion<double>> kBodyTwist{"body_twist", "SI", "angular velocity and velocity",
                                                            Storage::kStep};
inline constexpr Variable<Vector3> kBodyUp{"body_up", "1", "the world's z", Storage::kStep};
inline constexpr Variable<double> kBodyHeight{"body_height", "m", "of the origin over the ground", Storage::kStep};
inline constexpr Variable<double> kJointTorque{"joint_torque", "N m", "sum of what acts on the joint", Storage::kStep};
inline constexpr Variable<double> kJointInertia{
    "joint_inertia", "kg m^2", "sum of rotors' and implicit servos' inertia at the joint", Storage::kStep};
inline constexpr Variable<SpatialForce<double>> kBodyForce{"body_force", "SI", "sum of moments and forces on the body",
                                                           Storage::kStep};
inline constexpr Variable<double> kJointAcceleration{"joint_acceleration", "rad/s^2", "of q", Storage::kStep};
inline constexpr Variable<SpatialMotion<double>> kBodyAcceleration{
    "body_acceleration", "SI", "proper: what an accelerometer feels", Storage::kStep};
// Variables of contacts with what can move; their forces are the pair phase's.
inline constexpr Variable<SpatialForce<double>> kPairForce{
    "pair_force", "SI", "held over the frame, in the body's axes at its start, about its origin"};
inline constexpr Variable<double> kContactDetail{
    "contact_detail", "1", "which shapes touch: 0 those of the feet, 1 bounding spheres, 2 all primitives"};
inline constexpr Variable<double> kPairTouch{"pair_touch", "1", "1 where pair_force of any body is not zero"};
inline constexpr Variable<double> kJointsYield{"joints_yield", "1",
                                               "1: joints give way to an impulse; 0: the robot recoils as one body"};

inline constexpr Variable<double> kEventFunction{
    "event_function", "SI", "changes its sign where forces jump: a gap, a distance from a limit", Storage::kStep};

inline constexpr Variable<StepManner> kStepManner{"step_manner", "1", "how the integrator moves in a step"};

// Variables that tell how well a motion has been integrated.
inline constexpr Variable<double> kIntegrationError{
    "integration_error", "SI", "estimated in the last frame: m, rad, their rates; relative beyond 1", Storage::kKept};
inline constexpr Variable<double> kSubsteps{"substeps", "1", "steps of the integrator in the last frame",
                                            Storage::kKept};
inline constexpr Variable<double> kIntegrationFault{"integration_fault", "1", "1: it stopped before the frame's end",
                                                    Storage::kKept};

inline constexpr Variable<SpatialMotion<double>> kBaseAcceleration{
    "base_acceleration", "SI", "proper, of the base, whose joints move as prescribed", Storage::kStep};
inline constexpr Variable<CentroidalStep<double>> kCentroidalStep{
    "centroidal_step", "SI", "momentum, forces and composite inertia over the step", Storage::kStep};
inline constexpr Variable<ArticulatedInertia<double>> kContactInertia{
    "contact_inertia", "SI", "what contacts add to a body's inertia in a step that looks ahead", Storage::kStep};
inline constexpr Variable<double> kContactTouch{"contact_touch", "1", "1 where contact_inertia holds", Storage::kStep};
inline constexpr Variable<CornerResponses<>> kSoleResponse{"sole_response", "SI", "normal forces on a sole's corners",
                                                           Storage::kStep};

inline constexpr Variable<TouchResponse<>> kTouchResponse{
    "touch_response", "SI", "normal force on the shapes of a touch sensor", Storage::kStep};

// Variables of sensors.
inline constexpr Variable<Vector3> kGyroscope{"gyroscope", "rad/s", "angular velocity in the sensor's axes",
                                              Storage::kKept};
inline constexpr Variable<Vector3> kAccelerometer{"accelerometer", "m/s^2", "specific force in the sensor's axes",
                                                  Storage::kKept};
inline constexpr Variable<CornerForces<>> kSolePressure{"sole_pressure", "N", "normal forces on a sole's corners",
                                                        Storage::kKept};
inline constexpr Variable<double> kPushForce{"push_force", "N", "of free bodies on a touch sensor, mean over the frame",
                                             Storage::kKept};
inline constexpr Variable<double> kTouchForce{"touch_force", "N", "with which ground and free bodies press on it",
                                              Storage::kKept};
inline constexpr Variable<double> kTouch{"touch", "1", "1 where touch_force is above touch_threshold, else 0",
                                         Storage::kKept};
inline constexpr Variable<Vector3> kSensedForce{"sensed_force", "N", "of a force sensor, in its axes", Storage::kKept};

// What sensors say of these, where a robot has a module for their errors.
inline constexpr Variable<Vector3> kGyroscopeReading{"gyroscope_reading", "rad/s", "gyroscope with its errors",
                                                     Storage::kKept};
inline constexpr Variable<Vector3> kAccelerometerReading{"accelerometer_reading", "m/s^2",
                                                         "accelerometer with its errors", Storage::kKept};
inline constexpr Variable<CornerForces<>> kSolePressureReading{"sole_pressure_reading", "N",
                                                               "sole_pressure with its errors", Storage::kKept};
inline constexpr Variable<double> kJointPositionReading{"joint_position_reading", "rad",
                                                        "joint_position with its errors", Storage::kKept};
inline constexpr Variable<double> kJointVelocityReading{"joint_velocity_reading", "rad/s",
                                                        "joint_velocity with its errors", Storage::kKept};
inline constexpr Variable<double> kMeasuredTorqueReading{"measured_torque_reading", "N m",
                                                         "measured_torque with its errors", Storage::kKept};
inline constexpr Variable<double> kTouchReading{"touch_reading", "1", "touch with its errors", Storage::kKept};
inline constexpr Variable<Vector3> kSensedForceReading{"sensed_force_reading", "N", "sensed_force with its errors",
                                                       Storage::kKept};

}  // namespace murosimf
