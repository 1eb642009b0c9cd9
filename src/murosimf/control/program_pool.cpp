#include "murosimf/control/program_pool.h"

#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <atomic>
#include <thread>
#include <utility>
#include <vector>

namespace murosimf {

namespace {

class SharedPool final : public ProgramPool {
 public:
  SharedPool(int threads, Task task)
      : task_(std::move(task)), arena_(threads > 0 ? threads : oneapi::tbb::task_arena::automatic) {}
  ~SharedPool() noexcept override { wait(); }

  void launch(int robot) override {
    arena_.execute([&] { group_.run([this, robot] { task_(robot); }); });
  }
  void wait() override {
    arena_.execute([&] { group_.wait(); });
  }

 private:
  Task task_;
  oneapi::tbb::task_arena arena_;
  oneapi::tbb::task_group group_;
};

class ThreadPerRobot final : public ProgramPool {
 public:
  ThreadPerRobot(int robots, Task task) : task_(std::move(task)), workers_(static_cast<std::size_t>(robots)) {
    for (int i = 0; i < robots; ++i) {
      Worker& worker = workers_[static_cast<std::size_t>(i)];
      worker.thread = std::thread([this, i, &worker] { serve(i, worker); });
    }
  }
  ~ThreadPerRobot() override {
    wait();
    for (Worker& worker : workers_) order(worker, Order::kStop);
    for (Worker& worker : workers_) worker.thread.join();
  }

  void launch(int robot) override { order(workers_[static_cast<std::size_t>(robot)], Order::kRun); }
  void wait() override {
    for (Worker& worker : workers_) worker.order.wait(Order::kRun);
  }

 private:
  enum class Order { kRest, kRun, kStop };
  struct Worker {
    std::atomic<Order> order{Order::kRest};
    std::thread thread;
  };
  static void order(Worker& worker, Order what) {
    worker.order = what;
    worker.order.notify_all();
  }
  void serve(int robot, Worker& worker) {
    for (;;) {
      worker.order.wait(Order::kRest);
      if (worker.order == Order::kStop) return;
      task_(robot);
      order(worker, Order::kRest);
    }
  }

  Task task_;
  std::vector<Worker> workers_;
};

}  // namespace

std::unique_ptr<ProgramPool> makeSharedPool(int threads, ProgramPool::Task task) {
  return std::make_unique<SharedPool>(threads, std::move(task));
}

std::unique_ptr<ProgramPool> makeThreadPerRobot(int robots, ProgramPool::Task task) {
  return std::make_unique<ThreadPerRobot>(robots, std::move(task));
}

}  // namespace murosimf
