#pragma once

/// @file The sensors that a module for errors exists of (sensor_errors.h), with their words.

#include "murosimf/modules/sensing/sensor_errors.h"

namespace murosimf {

inline constexpr SensorWords<Vector3> kGyroscopeErrors{"gyroscope_errors",
                                                       subset::kImus,
                                                       kGyroscope,
                                                       kGyroscopeReading,
                                                       {"gyroscope_bias", "rad/s", "drawn once", Storage::kKept},
                                                       {"gyroscope_samples", "rad/s", "on their way"},
                                                       {"gyroscope_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<Vector3> kAccelerometerErrors{
    "accelerometer_errors",
    subset::kImus,
    kAccelerometer,
    kAccelerometerReading,
    {"accelerometer_bias", "m/s^2", "drawn once", Storage::kKept},
    {"accelerometer_samples", "m/s^2", "on their way"},
    {"accelerometer_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<CornerForces<>> kFootPressureErrors{
    "foot_pressure_errors",
    subset::kSoles,
    kSolePressure,
    kSolePressureReading,
    {"sole_pressure_bias", "N", "drawn once", Storage::kKept},
    {"sole_pressure_samples", "N", "on their way"},
    {"sole_pressure_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<double> kJointPositionErrors{
    "joint_position_errors",
    subset::kJoints,
    kJointPosition,
    kJointPositionReading,
    {"joint_position_bias", "rad", "drawn once", Storage::kKept},
    {"joint_position_samples", "rad", "on their way"},
    {"joint_position_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<double> kJointVelocityErrors{
    "joint_velocity_errors",
    subset::kJoints,
    kJointVelocity,
    kJointVelocityReading,
    {"joint_velocity_bias", "rad/s", "drawn once", Storage::kKept},
    {"joint_velocity_samples", "rad/s", "on their way"},
    {"joint_velocity_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<double> kJointTorqueErrors{"joint_torque_errors",
                                                        subset::kJoints,
                                                        kMeasuredTorque,
                                                        kMeasuredTorqueReading,
                                                        {"measured_torque_bias", "N m", "drawn once", Storage::kKept},
                                                        {"measured_torque_samples", "N m", "on their way"},
                                                        {"measured_torque_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<Vector3> kForceErrors{"force_errors",
                                                   subset::kForceSensors,
                                                   kSensedForce,
                                                   kSensedForceReading,
                                                   {"sensed_force_bias", "N", "drawn once", Storage::kKept},
                                                   {"sensed_force_samples", "N", "on their way"},
                                                   {"sensed_force_started", "1", "1 from the first sample on"}};

inline constexpr SensorWords<double> kTouchErrors{"touch_errors",
                                                  subset::kTouchSensors,
                                                  kTouch,
                                                  kTouchReading,
                                                  {"touch_bias", "1", "0", Storage::kKept},
                                                  {"touch_samples", "1", "on their way"},
                                                  {"touch_started", "1", "1 from the first sample on"},
                                                  true};

}  // namespace murosimf
