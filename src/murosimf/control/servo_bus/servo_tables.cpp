#include "murosimf/control/servo_bus/servo_tables.h"

#include <numbers>

namespace murosimf::servo_bus {

namespace {

using enum Item;
// clang-format off: tables are read by columns
constexpr Access kR = Access::kRead, kRW = Access::kReadWrite;
constexpr std::int64_t kAll8 = 255, kAll16 = 65535, kAll32 = 4294967295;
constexpr double kRpm = 2 * std::numbers::pi / 60;
constexpr double kUnit2 = 0.229 * kRpm;  // of velocities in version 2.0

// Stall torque [N m], stall current [A] and no-load speed at 12 V.
constexpr Model kModels[] = {
    {"MX-28", 29, 30, {2.5, 1.4, 55 * kRpm, 0, kUnit2}, 160, 0, 380, 850, false, false},
    {"MX-64", 310, 311, {6.0, 4.1, 63 * kRpm, 3.36e-3, kUnit2}, 240, 1941, 435, 850, true, false},
    {"MX-106", 320, 321, {8.4, 5.2, 45 * kRpm, 3.36e-3, kUnit2}, 160, 2047, 360, 850, true, false},
    {"XH540-W150", 0, 1110, {7.1, 4.9, 70 * kRpm, 2.69e-3, kUnit2}, 160, 2047, 300, 800, true, true},
    {"XH540-W270", 0, 1100, {9.9, 4.9, 39 * kRpm, 2.69e-3, kUnit2}, 160, 2047, 167, 800, true, true},
};

// MX with version 1.0. Velocities 0.114 rev/min, loads 0.1 %, torques 0.1 % of the largest.
constexpr Register kTable1[] = {
    {0, 2, "Model Number", kR, 0, 0, kAll16, "", kModelNumber},
    {2, 1, "Firmware Version", kR, 41, 0, kAll8, "", kFirmwareVersion},
    {3, 1, "ID", kRW, 1, 0, 253, "", kId},
    {4, 1, "Baud Rate", kRW, 34, 0, 254, "2 Mbps / (value + 1)", kStored},
    {5, 1, "Return Delay Time", kRW, 250, 0, 254, "2 us", kReturnDelayTime},
    {6, 2, "CW Angle Limit", kRW, 0, 0, 4095, "1/4096 turn", kLeastPosition},
    {8, 2, "CCW Angle Limit", kRW, 4095, 0, 4095, "1/4096 turn", kLargestPosition},
    {11, 1, "Temperature Limit", kRW, 80, 0, 99, "deg C", kTemperatureLimit},
    {12, 1, "Min Voltage Limit", kRW, 60, 50, 250, "0.1 V", kLeastVoltage},
    {13, 1, "Max Voltage Limit", kRW, 160, 50, 250, "0.1 V", kLargestVoltage},
    {14, 2, "Max Torque", kRW, 1023, 0, 1023, "0.1 %", kLargestTorque},
    {16, 1, "Status Return Level", kRW, 2, 0, 2, "", kStatusReturnLevel},
    {17, 1, "Alarm LED", kRW, 36, 0, 127, "bits", kStored},
    {18, 1, "Shutdown", kRW, 36, 0, 127, "bits", kShutdown},
    {20, 2, "Multi Turn Offset", kRW, 0, -24576, 24576, "1/4096 turn", kMultiTurnOffset, true},
    {22, 1, "Resolution Divider", kRW, 1, 1, 4, "", kStored},
    {24, 1, "Torque Enable", kRW, 0, 0, 1, "", kTorqueEnable},
    {25, 1, "LED", kRW, 0, 0, 1, "", kStored},
    {26, 1, "D Gain", kRW, 0, 0, 254, "4/1000", kPositionD},
    {27, 1, "I Gain", kRW, 0, 0, 254, "1000/2048", kStored},
    {28, 1, "P Gain", kRW, 32, 0, 254, "1/8", kPositionP},
    {30, 2, "Goal Position", kRW, 0, -28672, 28672, "1/4096 turn", kGoalPosition, true},
    {32, 2, "Moving Speed", kRW, 0, 0, 2047, "0.114 rev/min", kProfileVelocity},
    {34, 2, "Torque Limit", kRW, 1023, 0, 1023, "0.1 %", kTorqueLimit},
    {36, 2, "Present Position", kR, 0, 0, kAll16, "1/4096 turn", kPresentPosition, true},
    {38, 2, "Present Speed", kR, 0, 0, 2047, "0.114 rev/min", kPresentVelocity},
    {40, 2, "Present Load", kR, 0, 0, 2047, "0.1 %", kPresentLoad},
    {42, 1, "Present Voltage", kR, 0, 0, kAll8, "0.1 V", kPresentVoltage},
    {43, 1, "Present Temperature", kR, 0, 0, kAll8, "deg C", kPresentTemperature},
    {44, 1, "Registered", kR, 0, 0, 1, "", kRegistered},
    {46, 1, "Moving", kR, 0, 0, 1, "", kMoving},
    {47, 1, "Lock", kRW, 0, 0, 1, "", kLock},
    {48, 2, "Punch", kRW, 0, 0, 1023, "", kStored},
    {50, 2, "Realtime Tick", kR, 0, 0, 32767, "ms", kRealtimeTick},
    {73, 1, "Goal Acceleration", kRW, 0, 0, 254, "8.583 deg/s^2", kGoalAcceleration},
};
constexpr Register kCurrent1[] = {
    {68, 2, "Current", kR, 2048, 0, 4095, "4.5 mA, from 2048 on", kPresentCurrent},
    {70, 1, "Torque Ctrl Mode Enable", kRW, 0, 0, 1, "", kTorqueMode},
    {71, 2, "Goal Torque", kRW, 0, 0, 2047, "4.5 mA", kGoalTorque},
};

constexpr Register kTable2[] = {
    {0, 2, "Model Number", kR, 0, 0, kAll16, "", kModelNumber},
    {2, 4, "Model Information", kR, 0, 0, kAll32, "", kStored},
    {6, 1, "Firmware Version", kR, 46, 0, kAll8, "", kFirmwareVersion},
    {7, 1, "ID", kRW, 1, 0, 252, "", kId},
    {8, 1, "Baud Rate", kRW, 1, 0, 7, "", kStored},
    {9, 1, "Return Delay Time", kRW, 250, 0, 254, "2 us", kReturnDelayTime},
    {10, 1, "Drive Mode", kRW, 0, 0, 13, "bits", kDriveMode},
    {11, 1, "Operating Mode", kRW, 3, 0, 16, "", kOperatingMode},
    {12, 1, "Secondary(Shadow) ID", kRW, 255, 0, 255, "", kSecondaryId},
    {13, 1, "Protocol Type", kRW, 2, 1, 2, "", kStored},
    {20, 4, "Homing Offset", kRW, 0, -1044479, 1044479, "1/4096 turn", kHomingOffset, true},
    {24, 4, "Moving Threshold", kRW, 10, 0, 1023, "0.229 rev/min", kMovingThreshold},
    {31, 1, "Temperature Limit", kRW, 80, 0, 100, "deg C", kTemperatureLimit},
    {32, 2, "Max Voltage Limit", kRW, 160, 95, 160, "0.1 V", kLargestVoltage},
    {34, 2, "Min Voltage Limit", kRW, 95, 95, 160, "0.1 V", kLeastVoltage},
    {36, 2, "PWM Limit", kRW, 885, 0, 885, "0.113 %", kPwmLimit},
    {44, 4, "Velocity Limit", kRW, 0, 0, 1023, "0.229 rev/min", kVelocityLimit},
    {48, 4, "Max Position Limit", kRW, 4095, 0, 4095, "1/4096 turn", kLargestPosition},
    {52, 4, "Min Position Limit", kRW, 0, 0, 4095, "1/4096 turn", kLeastPosition},
    {63, 1, "Shutdown", kRW, 52, 0, kAll8, "bits", kShutdown},
    {64, 1, "Torque Enable", kRW, 0, 0, 1, "", kTorqueEnable},
    {65, 1, "LED", kRW, 0, 0, 1, "", kStored},
    {68, 1, "Status Return Level", kRW, 2, 0, 2, "", kStatusReturnLevel},
    {69, 1, "Registered Instruction", kR, 0, 0, 1, "", kRegistered},
    {70, 1, "Hardware Error Status", kR, 0, 0, kAll8, "bits", kHardwareError},
    {76, 2, "Velocity I Gain", kRW, 1920, 0, 16383, "1/65536", kStored},
    {78, 2, "Velocity P Gain", kRW, 100, 0, 16383, "1/128", kVelocityP},
    {80, 2, "Position D Gain", kRW, 0, 0, 16383, "1/16", kPositionD},
    {82, 2, "Position I Gain", kRW, 0, 0, 16383, "1/65536", kStored},
    {84, 2, "Position P Gain", kRW, 0, 0, 16383, "1/128", kPositionP},
    {88, 2, "Feedforward 2nd Gain", kRW, 0, 0, 16383, "1/4", kStored},
    {90, 2, "Feedforward 1st Gain", kRW, 0, 0, 16383, "1/4", kStored},
    {98, 1, "Bus Watchdog", kRW, 0, 0, 127, "20 ms", kBusWatchdog, true},
    {100, 2, "Goal PWM", kRW, 885, -885, 885, "0.113 %", kGoalPwm, true},
    {104, 4, "Goal Velocity", kRW, 0, -1023, 1023, "0.229 rev/min", kGoalVelocity, true},
    {108, 4, "Profile Acceleration", kRW, 0, 0, 32767, "214.577 rev/min^2, or 1 ms", kProfileAcceleration},
    {112, 4, "Profile Velocity", kRW, 0, 0, 32767, "0.229 rev/min, or 1 ms", kProfileVelocity},
    {116, 4, "Goal Position", kRW, 0, -1048575, 1048575, "1/4096 turn", kGoalPosition, true},
    {120, 2, "Realtime Tick", kR, 0, 0, 32767, "ms", kRealtimeTick},
    {122, 1, "Moving", kR, 0, 0, 1, "", kMoving},
    {123, 1, "Moving Status", kR, 0, 0, kAll8, "bits", kMovingStatus},
    {124, 2, "Present PWM", kR, 0, 0, kAll16, "0.113 %", kPresentPwm, true},
    {128, 4, "Present Velocity", kR, 0, 0, kAll32, "0.229 rev/min", kPresentVelocity, true},
    {132, 4, "Present Position", kR, 0, 0, kAll32, "1/4096 turn", kPresentPosition, true},
    {136, 4, "Velocity Trajectory", kR, 0, 0, kAll32, "0.229 rev/min", kVelocityTrajectory, true},
    {140, 4, "Position Trajectory", kR, 0, 0, kAll32, "1/4096 turn", kPositionTrajectory, true},
    {144, 2, "Present Input Voltage", kR, 0, 0, kAll16, "0.1 V", kPresentVoltage},
    {146, 1, "Present Temperature", kR, 0, 0, kAll8, "deg C", kPresentTemperature},
};
constexpr Register kCurrent2[] = {
    {38, 2, "Current Limit", kRW, 0, 0, 2047, "3.36 mA (MX), 2.69 mA (XH540)", kCurrentLimit},
    {102, 2, "Goal Current", kRW, 0, -2047, 2047, "3.36 mA (MX), 2.69 mA (XH540)", kGoalCurrent, true},
    {126, 2, "Present Current", kR, 0, 0, kAll16, "3.36 mA (MX), 2.69 mA (XH540)", kPresentCurrent, true},
};
constexpr Register kLoad2[] = {{126, 2, "Present Load", kR, 0, 0, kAll16, "0.1 %", kPresentLoad, true}};
constexpr Register kMx2[] = {{40, 4, "Acceleration Limit", kRW, 32767, 0, 32767, "214.577 rev/min^2", kStored}};
constexpr Register kX2[] = {
    {56, 1, "External Port Mode 1", kRW, 3, 0, 3, "", kStored},
    {57, 1, "External Port Mode 2", kRW, 3, 0, 3, "", kStored},
    {58, 1, "External Port Mode 3", kRW, 3, 0, 3, "", kStored},
    {152, 2, "External Port Data 1", kRW, 0, 0, kAll16, "", kStored},
    {154, 2, "External Port Data 2", kRW, 0, 0, kAll16, "", kStored},
    {156, 2, "External Port Data 3", kRW, 0, 0, kAll16, "", kStored},
};

// Floats of IEEE 754 with the low byte first: rad/s, m/s^2, and a unit quaternion that turns the board's axes into
// those of a level frame.
constexpr Register kImuTable[] = {
    {0, 2, "Model Number", kR, 0xBAFF, 0, kAll16, "", kModelNumber},
    {6, 1, "Firmware Version", kR, 1, 0, kAll8, "", kFirmwareVersion},
    {7, 1, "ID", kRW, 241, 0, 252, "", kId},
    {8, 1, "Baud Rate", kRW, 3, 0, 7, "", kStored},
    {10, 1, "LED 0 red", kRW, 0, 0, kAll8, "", kStored},
    {11, 1, "LED 0 green", kRW, 0, 0, kAll8, "", kStored},
    {12, 1, "LED 0 blue", kRW, 0, 0, kAll8, "", kStored},
    {14, 1, "LED 1 red", kRW, 0, 0, kAll8, "", kStored},
    {15, 1, "LED 1 green", kRW, 0, 0, kAll8, "", kStored},
    {16, 1, "LED 1 blue", kRW, 0, 0, kAll8, "", kStored},
    {18, 1, "LED 2 red", kRW, 0, 0, kAll8, "", kStored},
    {19, 1, "LED 2 green", kRW, 0, 0, kAll8, "", kStored},
    {20, 1, "LED 2 blue", kRW, 0, 0, kAll8, "", kStored},
    {36, 4, "Gyroscope x", kR, 0, 0, kAll32, "float, rad/s", kGyroX},
    {40, 4, "Gyroscope y", kR, 0, 0, kAll32, "float, rad/s", kGyroY},
    {44, 4, "Gyroscope z", kR, 0, 0, kAll32, "float, rad/s", kGyroZ},
    {48, 4, "Accelerometer x", kR, 0, 0, kAll32, "float, m/s^2", kAccelerometerX},
    {52, 4, "Accelerometer y", kR, 0, 0, kAll32, "float, m/s^2", kAccelerometerY},
    {56, 4, "Accelerometer z", kR, 0, 0, kAll32, "float, m/s^2", kAccelerometerZ},
    {60, 4, "Orientation x", kR, 0, 0, kAll32, "float", kOrientationX},
    {64, 4, "Orientation y", kR, 0, 0, kAll32, "float", kOrientationY},
    {68, 4, "Orientation z", kR, 0, 0, kAll32, "float", kOrientationZ},
    {72, 4, "Orientation w", kR, 0x3F800000, 0, kAll32, "float", kOrientationW},
    {76, 1, "Button 0", kR, 0, 0, 1, "", kStored},
    {77, 1, "Button 1", kR, 0, 0, 1, "", kStored},
    {78, 1, "Button 2", kR, 0, 0, 1, "", kStored},
    {100, 1, "Gyroscope rate", kRW, 5, 0, kAll8, "of BMI088", kStored},
    {101, 1, "Accelerometer rate", kRW, 15, 0, kAll8, "of BMI088", kStored},
    {102, 1, "Gyroscope range", kRW, 3, 0, 4, "0: 125, 1: 250, 2: 500, 3: 1000, 4: 2000 deg/s", kGyroRange},
    {103, 1, "Accelerometer range", kRW, 1, 0, 3, "0: 3, 1: 6, 2: 12, 3: 24 g", kAccelerometerRange},
    {108, 1, "Adaptive gain", kRW, 0, 0, 1, "", kStored},
    {109, 1, "Bias estimation", kRW, 0, 0, 1, "", kStored},
    {110, 4, "Accelerometer gain", kRW, 0x3D23D70A, 0, kAll32, "float, 0.04", kAccelerometerGain},
    {114, 4, "Bias alpha", kRW, 0x3C23D70A, 0, kAll32, "float, 0.01", kStored},
};

// clang-format on

}  // namespace

std::span<const Model> models() { return kModels; }
std::span<const Register> registersOfVersion1() { return kTable1; }
std::span<const Register> currentRegistersOfVersion1() { return kCurrent1; }
std::span<const Register> registersOfVersion2() { return kTable2; }
std::span<const Register> currentRegistersOfVersion2() { return kCurrent2; }
std::span<const Register> loadRegistersOfVersion2() { return kLoad2; }
std::span<const Register> mxRegistersOfVersion2() { return kMx2; }
std::span<const Register> xRegistersOfVersion2() { return kX2; }
std::span<const Register> imuRegisters() { return kImuTable; }

}  // namespace murosimf::servo_bus
