#include "murosimf/simulation/block_record.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#ifdef __AVX__
#include <immintrin.h>
#endif

#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

constexpr std::size_t kPoseNumbers = 12, kTwistNumbers = 6;
constexpr std::size_t kCacheLine = 64;  // [bytes]
constexpr double kLeastBetween = 4e-3;  // [s] two steps that are kept
alignas(kCacheLine) constexpr double kZeros[8] = {};

/// Offsets of a column's first `components` numbers of each object; zeros where it is not there.
void append(const Batch& batch, std::string_view property, std::string_view of, std::size_t objects,
            std::size_t components, std::vector<int>& offsets) {
  const ColumnLayout* layout = batch.column(property, of);
  const bool there = layout != nullptr && layout->ref.memory == MemoryKind::kState;
  for (std::size_t i = 0; i < objects * components; ++i) {
    const auto object = static_cast<int>(i / components), component = static_cast<int>(i % components);
    offsets.push_back(there ? (layout->ref.offset + object * layout->components + component) * batch.width : -1);
  }
}

/// Writes one number of all lanes.
inline void put(const double* from, float* to, std::size_t width) {
  std::size_t lane = 0;
#ifdef __AVX__
  for (; lane + 4 <= width; lane += 4) _mm_stream_ps(to + lane, _mm256_cvtpd_ps(_mm256_loadu_pd(from + lane)));
#endif
  for (; lane < width; ++lane) to[lane] = static_cast<float>(from[lane]);
}

}  // namespace

BlockRecord::BlockRecord(const Batch& batch) : width_(static_cast<std::size_t>(batch.width)) {
  const ColumnLayout* q = batch.column(kJointPosition.name, subset::kJoints);
  const ColumnLayout* base = batch.column(kBasePose.name, subset::kSelf);
  if (q == nullptr || base == nullptr || base->writer < 0) return;
  phase_ = batch.passes[static_cast<std::size_t>(base->writer)].phase;
  period_ = batch.passes[static_cast<std::size_t>(base->writer)].period;
  const double dt = batch.passes[static_cast<std::size_t>(base->writer)].dt;
  kept_every_ = std::max(1, static_cast<int>(std::ceil(kLeastBetween / dt - 1e-9)));
  joints_ = static_cast<std::size_t>(q->objects);
  append(batch, kBasePose.name, subset::kSelf, 1, kPoseNumbers, offsets_);
  append(batch, kBaseVelocity.name, subset::kSelf, 1, kTwistNumbers, offsets_);
  append(batch, kJointPosition.name, subset::kJoints, joints_, 1, offsets_);
  append(batch, kJointVelocity.name, subset::kJoints, joints_, 1, offsets_);
  judged_ = offsets_.size();
  append(batch, kJointCommand.name, subset::kJoints, joints_, 1, offsets_);
  blocks_ = static_cast<std::size_t>(batch.capacity());
  heads_.resize(blocks_ * kSteps);
  const std::size_t bytes = heads_.size() * offsets_.size() * width_ * sizeof(float);
  const std::size_t lines = (bytes + kCacheLine - 1) / kCacheLine;
  numbers_.reset(static_cast<float*>(std::aligned_alloc(kCacheLine, lines * kCacheLine)));
  if (numbers_ == nullptr) throw std::bad_alloc();
}

bool BlockRecord::moves(Phase phase, long frame) const {
  return !offsets_.empty() && phase == phase_ && frame % period_ == 0;
}

std::uint32_t BlockRecord::look(int block, const double* state, long frame, double time,
                                std::span<const int> residents) {
  const std::uint32_t wrong = judge(state);
  const long step = frame / period_;
  if (wrong == 0 && step % kept_every_ != 0) return 0;
  // The next one to be kept has another place, also behind one that is kept out of turn.
  const auto slot = static_cast<std::size_t>((step + kept_every_ - 1) / kept_every_) % kSteps;
  write(slot * blocks_ + static_cast<std::size_t>(block), state, time, residents);
  return wrong;
}

/// A sum of sizes is as good a number as the worst of them.
std::uint32_t BlockRecord::judge(const double* state) const {
  const std::span<const int> judged = std::span(offsets_).first(judged_);
  std::uint32_t wrong = 0;
  std::size_t lane = 0;
#ifdef __AVX__
  for (; lane + 4 <= width_; lane += 4) {
    __m256d sum = _mm256_setzero_pd();
    for (const int offset : judged) {
      const double* number = offset < 0 ? kZeros : state + offset;
      sum = _mm256_add_pd(sum, _mm256_andnot_pd(_mm256_set1_pd(-0.0), _mm256_loadu_pd(number + lane)));
    }
    const __m256d good = _mm256_cmp_pd(sum, _mm256_set1_pd(kLargest), _CMP_LT_OQ);
    wrong |= (~static_cast<std::uint32_t>(_mm256_movemask_pd(good)) & 15U) << lane;
  }
#endif
  for (; lane < width_; ++lane) {
    double sum = 0;
    for (const int offset : judged) sum += std::abs((offset < 0 ? kZeros : state + offset)[lane]);
    wrong |= sum < kLargest ? 0U : 1U << lane;
  }
  return wrong;
}

void BlockRecord::write(std::size_t place, const double* state, double time, std::span<const int> residents) {
  Head& head = heads_[place];
  head.time = time;
  head.residents.fill(-1);
  std::copy(residents.begin(), residents.end(), head.residents.begin());
  float* to = numbersOf(place);
  for (const int offset : offsets_) {
    put(offset < 0 ? kZeros : state + offset, to, width_);
    to += width_;
  }
}

void BlockRecord::clear() { std::fill(heads_.begin(), heads_.end(), Head{}); }

void BlockRecord::find(int resident, double after, std::vector<RecordedStep>& steps) const {
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    const auto& seats = heads_[i].residents;
    const auto lane = std::find(seats.begin(), seats.end(), resident) - seats.begin();
    if (heads_[i].time <= after || lane == static_cast<std::ptrdiff_t>(seats.size())) continue;
    steps.push_back(read(numbersOf(i) + lane, heads_[i].time));
  }
}

RecordedStep BlockRecord::read(const float* lane, double time) const {
  std::size_t next = 0;
  const auto number = [&] { return static_cast<double>(lane[next++ * width_]); };
  const auto vector = [&] {
    const double x = number(), y = number(), z = number();
    return Vector3{x, y, z};
  };
  RecordedStep step;
  step.time = time;
  step.X_WB.rotation.x = vector(), step.X_WB.rotation.y = vector(), step.X_WB.rotation.z = vector();
  step.X_WB.rotation = orthonormalized(step.X_WB.rotation);
  step.X_WB.translation = vector();
  step.V_WB.w = vector(), step.V_WB.v = vector();
  for (std::vector<double>* list : {&step.q, &step.dq, &step.command}) {
    for (std::size_t j = 0; j < joints_; ++j) list->push_back(number());
  }
  return step;
}

}  // namespace murosimf
