#include "experiment/batch_board.h"

#include <sys/mman.h>

#include <new>
#include <stdexcept>

namespace murosimf {

static_assert(std::atomic<int>::is_always_lock_free, "a lock would stay held by a worker that was killed");

BatchBoard::BatchBoard(int workers, std::size_t runs)
    : workers_(workers), runs_(runs), bytes_((static_cast<std::size_t>(workers) + runs) * sizeof(std::atomic<int>)) {
  void* memory = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("there is no memory that processes can share");
  numbers_ = static_cast<std::atomic<int>*>(memory);
  for (std::size_t i = 0; i < static_cast<std::size_t>(workers) + runs; ++i) {
    new (numbers_ + i) std::atomic<int>(i < static_cast<std::size_t>(workers) ? -1 : 0);
  }
}

BatchBoard::~BatchBoard() { munmap(numbers_, bytes_); }

std::size_t BatchBoard::count(RunState wanted) const {
  std::size_t found = 0;
  for (std::size_t i = 0; i < runs_; ++i) found += state(i) == wanted ? 1u : 0u;
  return found;
}

}  // namespace murosimf
