#include "get_up_motion.h"

#include <span>

namespace murosimf::controllers {

namespace {

/// One row of the motion, both sides alike; angles in degrees. Waist, head, hip yaw, hip roll and ankle roll are 0.
struct GetUpRow {
  double duration;
  double shoulder_pitch, shoulder_roll, elbow;  // shoulder_roll: outwards
  double hip_pitch, knee, ankle_pitch;
};

constexpr GetUpRow kBackRows[] = {
    {.40, 60, 15, -90, -30, 60, 0},   // elbows behind the trunk
    {.50, 65, 15, 0, -100, 120, 0},   // the arms lift the hips
    {.50, 95, 15, 0, -110, 60, 0},    // over the head
    {.40, 120, 15, 0, -110, 0, -30},  // toes on the floor beyond the head
    {.50, 60, 15, 0, -40, 0, -40},    // let down
    {.50, 20, 15, -30, 0, 0, -70},    // prone
};
constexpr GetUpRow kFrontRows[] = {
    {.40, -30, 15, -130, 0, 0, -70},      // fold the arms
    {.50, -100, 15, 0, -30, 20, -70},     // push up
    {.70, -85, 15, -20, -109, 92, -70},   // feet flat, trunk level
    {.50, -40, 15, -50, -110, 125, -70},  // the arms load
    {.18, -65, 15, 0, -110, 135, -70},    // push
    {.30, -30, 15, 0, -95, 135, -70},     // centre of mass over the toes
    {.50, 20, 15, -20, -70, 132, -67},    // squat
};
constexpr GetUpRow kFlankRows[] = {
    {.50, 90, 45, 0, 0, 0, 0},  // arms behind the back
    {.30, 90, 45, 0, 0, 0, 0},  // over
};
constexpr double kRiseTime = .80;  // to walk-ready

JointAngles anglesOf(const GetUpRow& row) {
  JointAngles angles{};
  for (const int side : {kRight, kLeft}) {
    double* arm = angles.data() + kFirstArmJoint[static_cast<std::size_t>(side)];
    double* leg = angles.data() + kFirstLegJoint[static_cast<std::size_t>(side)];
    arm[0] = degrees(row.shoulder_pitch), arm[1] = sideSign(side) * degrees(row.shoulder_roll);
    arm[2] = degrees(row.elbow);
    leg[kHipPitch] = degrees(row.hip_pitch), leg[kKnee] = degrees(row.knee);
    leg[kAnklePitch] = degrees(row.ankle_pitch);
  }
  return angles;
}

void append(std::vector<KeyFrame>& frames, std::span<const GetUpRow> rows) {
  for (const GetUpRow& row : rows) frames.push_back({row.duration, anglesOf(row), false});
}

}  // namespace

std::vector<KeyFrame> getUpFrames(LyingSide side, const JointAngles& walk_ready) {
  std::vector<KeyFrame> frames;
  if (side == LyingSide::kFlank) {
    append(frames, kFlankRows);
    return frames;
  }
  if (side == LyingSide::kBack) append(frames, kBackRows);
  append(frames, kFrontRows);
  frames.push_back({kRiseTime, walk_ready, false});
  return frames;
}

}  // namespace murosimf::controllers
