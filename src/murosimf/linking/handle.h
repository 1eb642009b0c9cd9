#pragma once

/// @file Handles: one robot's values of one column, found without names.
///
/// Lanes are out of sight: values of one robot stand `stride` numbers apart in its block. A handle goes on to hold when
/// its robot moves to another block, as it does when its level of detail is exchanged.

#include <concepts>
#include <cstddef>
#include <utility>

#include "murosimf/linking/block_answers.h"
#include "murosimf/linking/declaration.h"

namespace murosimf {

/// Values of one column of one lane.
template <class T>
class LaneValues {
 public:
  LaneValues(double* first, int stride) : first_(first), stride_(stride) {}
  /// Asks the memory for the values of so many objects, which will be read soon.
  void fetch(int objects) const {
    constexpr int kLine = 64 / sizeof(double);
    for (int i = 0; i < objects * kNumbers * stride_; i += kLine) __builtin_prefetch(first_ + i);
  }
  /// Asks for one member alone: three lines of a pose's twelve where only places are read.
  template <class Member, std::same_as<T> Whole>
  void fetch(Member Whole::*member, int objects = 1) const {
    const std::ptrdiff_t before = numbersBefore(member);
    for (int i = 0; i < objects; ++i) LaneValues<Member>(first_ + (i * kNumbers + before) * stride_, stride_).fetch(1);
  }
  /// Value of the subset's object number `object`.
  T get(int object = 0) const {
    const double* source = first_ + object * kNumbers * stride_;
    // Straight into the value: a copy by way of an array would wait for its own stores.
    T value;
    auto* target = reinterpret_cast<double*>(&value);
    forEachNumber([&](int i) { target[i] = source[i * stride_]; });
    return value;
  }
  void set(const T& value, int object = 0) const {
    double numbers[sizeof(T) / sizeof(double)];
    __builtin_memcpy(numbers, &value, sizeof(T));
    double* target = first_ + object * kNumbers * stride_;
    forEachNumber([&](int i) { target[i * stride_] = numbers[i]; });
  }
  /// Changes one member and leaves the others: a fifth of the writing where only positions of servo commands change.
  template <class Member, std::same_as<T> Whole>
  void set(Member Whole::*member, const Member& value, int object = 0) const {
    LaneValues<Member>(first_ + (object * kNumbers + numbersBefore(member)) * stride_, stride_).set(value);
  }

 private:
  static constexpr int kNumbers = static_cast<int>(sizeof(T) / sizeof(double));
  template <class Member, std::same_as<T> Whole>
  static std::ptrdiff_t numbersBefore(Member Whole::*member) {
    const T whole{};
    const auto bytes = reinterpret_cast<const char*>(&(whole.*member)) - reinterpret_cast<const char*>(&whole);
    return bytes / static_cast<std::ptrdiff_t>(sizeof(double));
  }
  /// Without a loop: -O2 would count at run time what is known here.
  template <class Visit>
  static void forEachNumber(Visit&& visit) {
    [&]<int... I>(std::integer_sequence<int, I...>) { (visit(I), ...); }
    (std::make_integer_sequence<int, kNumbers>());
  }
  double* first_;
  int stride_;
};

/// Where a robot's values of one column stand now, and when they are written.
struct ColumnCell {
  double* first = nullptr;  ///< null: the robot's present level of detail has no such column
  int stride = 1, objects = 0;
  int period = 1;                   ///< in frames between two updates; 1 when no module writes it
  Phase phase = Phase::kPrescribe;  ///< of the module that writes it
  BlockAnswers* answers = nullptr;  ///< to be asked before one looks; null: the values stand there
};

/// Valid as long as the linked world.
template <class T>
class Handle {
 public:
  Handle() = default;
  explicit Handle(const ColumnCell* cell) : cell_(cell) {}

  bool valid() const { return cell_->first != nullptr; }
  int size() const { return cell_->objects; }
  int period() const { return cell_->period; }
  Phase phase() const { return cell_->phase; }
  /// Values of all objects, where they stand until the next exchange of levels: for loops over many.
  LaneValues<T> values() const {
    if (cell_->answers != nullptr) cell_->answers->give();
    return {cell_->first, cell_->stride};
  }
  /// Value of the subset's object number `object`.
  T get(int object = 0) const { return values().get(object); }
  void set(const T& value, int object = 0) { values().set(value, object); }
  /// Changes one member and leaves the others.
  template <class Member, std::same_as<T> Whole>
  void set(Member Whole::*member, const Member& value, int object = 0) {
    values().set(member, value, object);
  }

 private:
  static constexpr ColumnCell kNowhere{};
  const ColumnCell* cell_ = &kNowhere;
};

}  // namespace murosimf
