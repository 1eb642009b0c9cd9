#include "murosimf/simulation/state_guard.h"

#include <algorithm>
#include <array>
#include <utility>

namespace murosimf {

const OutsideAccess& StateGuard::robotAccess() {
  static const OutsideAccess access([](Declaration& d) {
    d.needs(kTree);
    d.reads(kJointPosition, subset::kJoints);
    d.reads(kJointVelocity, subset::kJoints);
    d.reads(kJointCommand, subset::kJoints);
    d.reads(kBasePose);
    d.readsIfAdded(kBaseVelocity);
  });
  return access;
}

StateGuard::StateGuard(const World& world, LinkedWorld& linked, const std::vector<ObjectId>& robots)
    : world_(world), linked_(linked) {
  for (const ObjectId id : robots) {
    robots_.push_back({id, &linked.residentOf(id), StepHistory(linked, id), false, false, linked.handle(id, kBasePose),
                       linked.handle(id, kBasePoseLast), linked.handle(id, kBodyPose, subset::kBodies),
                       linked.handle(id, kBodyPoseLast, subset::kBodies),
                       linked.handle(id, kJointPosition, subset::kJoints), linked.handle(id, kPlacementCount),
                       linked.handle(id, kPlacementsShown), kernelRows(*world.findShared(id, kTree))});
  }
  robot_of_.assign(linked.residents().size(), -1);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    robot_of_[static_cast<std::size_t>(robots_[i].resident - linked.residents().data())] = static_cast<int>(i);
  for (const Batch& batch : linked.batches()) records_.emplace_back(batch);
  keepHistories();
}

/// What a frame writes stands together: of a thousand robots in rings of their own, each would be on another page.
void StateGuard::keepHistories() {
  std::size_t stride = 0;
  for (const Robot& robot : robots_) {
    stride += robot.history.width();
    widest_ = std::max(widest_, robot.history.width());
  }
  histories_.resize(StepHistory::kSteps * stride);
  float* next = histories_.data();
  for (Robot& robot : robots_) {
    robot.history.keepAt(next, stride);
    next += robot.history.width();
  }
}

/// Where the state of robot `number` goes; that of a robot that is held, or of nobody, goes nowhere.
float* StateGuard::rowOf(int number) {
  thread_local AlignedDoubles nowhere;
  if (number >= 0 && !robots_[static_cast<std::size_t>(number)].frozen)
    return robots_[static_cast<std::size_t>(number)].history.nextRow();
  if (nowhere.size() < widest_) nowhere = AlignedDoubles(widest_);
  return reinterpret_cast<float*>(nowhere.data());
}

/// Those of one block move in the same phase. Of the block that comes next the robots are asked for.
void StateGuard::look(std::size_t batch, int block, Phase phase, long frame) {
  constexpr std::size_t kMostLanes = 8;
  const std::span<const int> residents = linked_.seatedIn(batch, block);
  const int first = robot_of_[static_cast<std::size_t>(residents.front())];
  if (first < 0 || !robots_[static_cast<std::size_t>(first)].history.moved(phase, frame)) return;
  std::array<int, kMostLanes> numbers{};
  std::array<float*, kMostLanes> rows{};
  const Batch& of = linked_.batches()[batch];
  const auto lanes = static_cast<std::size_t>(of.width);
  for (std::size_t i = 0; i < lanes; ++i) {
    numbers[i] = i < residents.size() ? robot_of_[static_cast<std::size_t>(residents[i])] : -1;
    rows[i] = rowOf(numbers[i]);
    const std::size_t ahead = static_cast<std::size_t>(std::max(numbers[i], 0)) + lanes;
    if (ahead < robots_.size()) __builtin_prefetch(&robots_[ahead].history), __builtin_prefetch(&robots_[ahead].frozen);
  }
  const double time = static_cast<double>(frame + 1) * linked_.frameLength();
  const std::uint32_t wrong =
      records_[batch].write(of.state[static_cast<std::size_t>(block)].data(), time, std::span(rows).first(lanes));
  if (wrong == 0) return;
  for (std::size_t i = 0; i < residents.size(); ++i) {
    if (numbers[i] < 0 || (wrong >> i & 1U) == 0) continue;
    Robot& robot = robots_[static_cast<std::size_t>(numbers[i])];
    if (!robot.frozen) robot.wrong = any_wrong_ = true;
  }
}

void StateGuard::freeze(long frame) {
  if (!any_wrong_ && frozen_ == 0) return;
  for (Robot& robot : robots_) {
    if (robot.frozen) hold(robot);
    if (std::exchange(robot.wrong, false)) freezeAt(robot, static_cast<double>(frame + 1) * linked_.frameLength());
  }
  any_wrong_ = false;
}

void StateGuard::freezeAt(Robot& robot, double time) {
  Fault& fault = faults_.emplace_back(Fault{robot.object, time, robot.history.fault(world_), {}});
  for (int i = 0; i < robot.history.size(); ++i) fault.steps.push_back(robot.history.step(i));
  robot.history.clear();
  robot.frozen = true, ++frozen_;
  linked_.beginAnew(robot.object);
  if (fault.steps.size() > 1) {
    const StepHistory::Step& last = fault.steps[fault.steps.size() - 2];
    robot.base.set(last.X_WB);
    for (int j = 0; j < robot.q.size(); ++j) robot.q.set(last.q[static_cast<std::size_t>(j)], j);
  }
  robot.X_WB = robot.base.get();
  robot.at.clear();
  for (int j = 0; j < robot.q.size(); ++j) robot.at.push_back(robot.q.get(j));
  stop(robot);
}

/// Takes its state, at its present level, as that of a robot that has never moved.
void StateGuard::stop(Robot& robot) {
  linked_.beginAnew(robot.object);
  robot.base.set(robot.X_WB);
  if (robot.base_last.valid()) robot.base_last.set(robot.X_WB);
  for (std::size_t j = 0; j < robot.at.size(); ++j) robot.q.set(robot.at[j], static_cast<int>(j));
  std::vector<Pose> X_WR{robot.X_WB};
  for (std::size_t i = 1; i < robot.rows.size(); ++i) {
    X_WR.push_back(childPose(X_WR[static_cast<std::size_t>(robot.rows[i].parent)], robot.rows[i], robot.at[i - 1]));
  }
  for (Handle<Pose>* bodies : {&robot.bodies, &robot.bodies_last}) {
    for (int i = 0; i < bodies->size(); ++i) bodies->set(X_WR[static_cast<std::size_t>(i)], i);
  }
  if (robot.shown.valid()) robot.shown.set(robot.placements.get());
  robot.level = robot.resident->level;
  robot.memory.clear();
  linked_.visitMemory(linked_.placeOf(*robot.resident), [&](double& value) { robot.memory.push_back(value); });
}

void StateGuard::hold(Robot& robot) {
  if (robot.level != robot.resident->level) return stop(robot);
  auto next = robot.memory.cbegin();
  linked_.visitMemory(linked_.placeOf(*robot.resident), [&](double& value) { value = *next++; });
}

void StateGuard::thaw(ObjectId object) {
  for (Robot& robot : robots_) {
    if (robot.object == object && std::exchange(robot.frozen, false)) --frozen_;
  }
}

void StateGuard::archive(StateArchive& archive) {
  for (Robot& robot : robots_) archive(robot);
  archive(faults_);
  frozen_ = static_cast<int>(std::count_if(robots_.begin(), robots_.end(), [](const Robot& r) { return r.frozen; }));
}

}  // namespace murosimf
