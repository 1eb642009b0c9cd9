#include "murosimf/simulation/block_record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#ifdef __AVX__
#include <immintrin.h>
#endif

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr int kWidest = 8;
alignas(64) constexpr double kZeros[kWidest] = {};

/// Offsets of a column's first `components` numbers of each object; zeros where it is not there.
void append(const Batch& batch, std::string_view property, std::string_view of, int objects, int components,
            std::vector<int>& numbers) {
  const ColumnLayout* layout = batch.column(property, of);
  const bool there = layout != nullptr && layout->ref.memory == MemoryKind::kState;
  for (int i = 0; i < objects; ++i) {
    for (int c = 0; c < components; ++c)
      numbers.push_back(there ? layout->ref.offset + i * layout->components + c : -1);
  }
}

/// The four lanes from `lane` on, of each of four numbers in turn.
#ifdef __AVX__
using Four = __m128;
inline Four loadFour(const double* numbers) { return _mm256_cvtpd_ps(_mm256_loadu_pd(numbers)); }
inline Four allFour(float number) { return _mm_set1_ps(number); }
inline std::uint32_t wrongOf(Four numbers) {
  const Four size = _mm_andnot_ps(_mm_set1_ps(-0.0F), numbers);
  const Four good = _mm_cmplt_ps(size, _mm_set1_ps(static_cast<float>(BlockRecord::kLargest)));
  return ~static_cast<std::uint32_t>(_mm_movemask_ps(good)) & 15U;
}
inline void putRows(Four a, Four b, Four c, Four d, float* const* rows, std::size_t at) {
  _MM_TRANSPOSE4_PS(a, b, c, d);
  _mm_stream_ps(rows[0] + at, a), _mm_stream_ps(rows[1] + at, b);
  _mm_stream_ps(rows[2] + at, c), _mm_stream_ps(rows[3] + at, d);
}
#else
using Four = std::array<float, 4>;
inline Four loadFour(const double* numbers) {
  Four four;
  for (std::size_t k = 0; k < 4; ++k) four[k] = static_cast<float>(numbers[k]);
  return four;
}
inline Four allFour(float number) { return {number, number, number, number}; }
inline std::uint32_t wrongOf(const Four& numbers) {
  std::uint32_t wrong = 0;
  for (std::size_t k = 0; k < 4; ++k)
    wrong |= std::abs(numbers[k]) < static_cast<float>(BlockRecord::kLargest) ? 0U : 1U << k;
  return wrong;
}
inline void putRows(const Four& a, const Four& b, const Four& c, const Four& d, float* const* rows, std::size_t at) {
  for (std::size_t k = 0; k < 4; ++k)
    rows[k][at] = a[k], rows[k][at + 1] = b[k], rows[k][at + 2] = c[k], rows[k][at + 3] = d[k];
}
#endif

}  // namespace

BlockRecord::BlockRecord(const Batch& batch) : width_(batch.width) {
  const ColumnLayout* q = batch.column(kJointPosition.name, subset::kJoints);
  if (q == nullptr || batch.column(kBasePose.name, subset::kSelf) == nullptr) return;
  append(batch, kBasePose.name, subset::kSelf, 1, static_cast<int>(kPoseNumbers), numbers_);
  append(batch, kBaseVelocity.name, subset::kSelf, 1, static_cast<int>(kTwistNumbers), numbers_);
  append(batch, kJointPosition.name, subset::kJoints, q->objects, 1, numbers_);
  append(batch, kJointVelocity.name, subset::kJoints, q->objects, 1, numbers_);
  judged_ = numbers_.size();
  append(batch, kJointCommand.name, subset::kJoints, q->objects, 1, numbers_);
}

/// Four numbers of four lanes at a time; a block of one lane as if it had four.
std::uint32_t BlockRecord::write(const double* state, double time, std::span<float* const> rows) const {
  if (numbers_.empty()) return 0;
  std::array<float, kTimeNumbers> clock{};
  std::memcpy(clock.data(), &time, sizeof(time));
  const std::size_t numbers = numbers_.size(), joints = (numbers - kPoseNumbers - kTwistNumbers) / kJointNumbers;
  std::uint32_t wrong = 0;
  for (std::size_t lane = 0; lane < rows.size(); lane += 4) {
    std::uint32_t wrong_here = 0;
    const auto number = [&](std::size_t i) -> Four {
      if (i >= numbers) return allFour(i < numbers + kTimeNumbers ? clock[i - numbers] : 0.0F);
      const double* first = numbers_[i] < 0 ? kZeros : state + static_cast<std::size_t>(numbers_[i] * width_) + lane;
      const Four four = width_ == 1 ? allFour(static_cast<float>(*first)) : loadFour(first);
      if (i < judged_) wrong_here |= wrongOf(four);
      return four;
    };
    std::array<float*, 4> targets{};
    for (std::size_t k = 0; k < 4; ++k) targets[k] = rows[std::min(lane + k, rows.size() - 1)];
    for (std::size_t i = 0; i < widthOf(joints); i += kTogether) {
      const Four a = number(i), b = number(i + 1), c = number(i + 2), d = number(i + 3);
      putRows(a, b, c, d, targets.data(), i);
    }
    wrong |= wrong_here << lane;
  }
  return wrong;
}

}  // namespace murosimf
