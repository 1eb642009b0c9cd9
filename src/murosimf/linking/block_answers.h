#pragma once

/// @file Variables of one block that are computed only when somebody outside asks (Storage::kOnDemand).

namespace murosimf {

struct Batch;

/// Asked by handles and by whoever walks over columns, on the thread that steps the frame: never while blocks run.
/// Cost: one comparison where the answer is known, else BlockModule::answer() for all robots of the block.
class BlockAnswers {
 public:
  BlockAnswers(const Batch& batch, int block) : batch_(&batch), block_(block) {}
  /// What they follow from has changed.
  void forget() {
    if (known_) known_ = false;  // a block's neighbours in memory belong to other threads
  }
  void give() {
    if (!known_) compute();
  }

 private:
  void compute();

  const Batch* batch_;
  int block_;
  bool known_ = false;
};

}  // namespace murosimf
