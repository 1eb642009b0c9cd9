#pragma once

/// @file Handles: one robot's values of one column, found without names.
///
/// Lanes are out of sight: values of one robot stand `stride` numbers apart in its block.

namespace murosimf {

/// Valid as long as the linked world.
template <class T>
class Handle {
 public:
  Handle() = default;
  Handle(double* first, int stride, int objects) : first_(first), stride_(stride), objects_(objects) {}

  bool valid() const { return first_ != nullptr; }
  int size() const { return objects_; }
  /// Value of the subset's object number `object`.
  T get(int object = 0) const {
    double numbers[sizeof(T) / sizeof(double)];
    const double* source = first_ + object * kNumbers * stride_;
    for (int i = 0; i < kNumbers; ++i) numbers[i] = source[i * stride_];
    T value;
    __builtin_memcpy(&value, numbers, sizeof(T));
    return value;
  }
  void set(const T& value, int object = 0) {
    double numbers[sizeof(T) / sizeof(double)];
    __builtin_memcpy(numbers, &value, sizeof(T));
    double* target = first_ + object * kNumbers * stride_;
    for (int i = 0; i < kNumbers; ++i) target[i * stride_] = numbers[i];
  }

 private:
  static constexpr int kNumbers = static_cast<int>(sizeof(T) / sizeof(double));
  double* first_ = nullptr;
  int stride_ = 1;
  int objects_ = 0;
};

}  // namespace murosimf
