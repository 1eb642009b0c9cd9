#include "murosimf/simulation/state_guard.h"

#include <algorithm>
#include <utility>

#include "murosimf/simulation/wrong_number.h"
#include "murosimf/world/vocabulary.h"

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
    robots_.push_back({id, &linked.residentOf(id), false, false, -1, linked.handle(id, kBasePose),
                       linked.handle(id, kBasePoseLast), linked.handle(id, kShownBase),
                       linked.handle(id, kShownBaseLast), linked.handle(id, kJointPosition, subset::kJoints),
                       linked.handle(id, kShownPosition, subset::kJoints),
                       linked.handle(id, kShownPositionLast, subset::kJoints), linked.handle(id, kPlacementCount),
                       linked.handle(id, kPlacementsShown)});
  }
  robot_of_.assign(linked.residents().size(), -1);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    robot_of_[static_cast<std::size_t>(robots_[i].resident - linked.residents().data())] = static_cast<int>(i);
  for (const Batch& batch : linked.batches()) records_.emplace_back(batch);
}

void StateGuard::look(std::size_t batch, int block, Phase phase, long frame) {
  BlockRecord& record = records_[batch];
  if (!record.moves(phase, frame)) return;
  const std::span<const int> residents = linked_.seatedIn(batch, block);
  const double time = static_cast<double>(frame + 1) * linked_.frameLength();
  const double* state = linked_.batches()[batch].state[static_cast<std::size_t>(block)].data();
  const std::uint32_t wrong = record.look(block, state, frame, time, residents);
  if (wrong == 0) return;
  for (std::size_t i = 0; i < residents.size(); ++i) {
    const int number = robot_of_[static_cast<std::size_t>(residents[i])];
    if (number < 0 || (wrong >> i & 1U) == 0) continue;
    Robot& robot = robots_[static_cast<std::size_t>(number)];
    if (!robot.frozen) robot.wrong = any_wrong_ = true;
  }
}

void StateGuard::freeze(long frame) {
  time_ = static_cast<double>(frame + 1) * linked_.frameLength();
  if (!any_wrong_ && frozen_ == 0) return;
  for (Robot& robot : robots_) {
    if (robot.frozen) hold(robot);
    if (std::exchange(robot.wrong, false)) freezeAt(robot, time_);
  }
  any_wrong_ = false;
}

/// From all blocks in which it has sat.
std::vector<RecordedStep> StateGuard::stepsOf(const Robot& robot) const {
  std::vector<RecordedStep> steps;
  const auto resident = static_cast<int>(robot.resident - linked_.residents().data());
  for (const BlockRecord& record : records_) record.find(resident, robot.since, steps);
  std::sort(steps.begin(), steps.end(), [](const RecordedStep& a, const RecordedStep& b) { return a.time < b.time; });
  if (steps.size() > BlockRecord::kSteps)
    steps.erase(steps.begin(), steps.end() - static_cast<std::ptrdiff_t>(BlockRecord::kSteps));
  return steps;
}

void StateGuard::freezeAt(Robot& robot, double time) {
  const Fault& fault =
      faults_.emplace_back(Fault{robot.object, time, wrongNumberOf(world_, linked_, robot.object), stepsOf(robot)});
  robot.frozen = true, ++frozen_;
  linked_.beginAnew(robot.object);
  if (fault.steps.size() > 1) {
    const RecordedStep& last = fault.steps[fault.steps.size() - 2];
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
  for (Handle<Pose>* base : {&robot.base, &robot.base_last, &robot.shown_base, &robot.shown_base_last})
    if (base->valid()) base->set(robot.X_WB);
  for (Handle<double>* q : {&robot.q, &robot.shown_q, &robot.shown_q_last}) {
    for (int j = 0; j < q->size(); ++j) q->set(robot.at[static_cast<std::size_t>(j)], j);
  }
  if (robot.placements_shown.valid()) robot.placements_shown.set(robot.placements.get());
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
    if (robot.object == object && std::exchange(robot.frozen, false)) --frozen_, robot.since = time_;
  }
}

/// What was kept belongs to another run, or to one that went on otherwise.
void StateGuard::forgetSteps() {
  for (BlockRecord& record : records_) record.clear();
  for (Robot& robot : robots_) robot.since = -1;
}

void StateGuard::archive(StateArchive& archive) {
  for (Robot& robot : robots_) archive(robot);
  archive(faults_);
  if (archive.loading()) forgetSteps();
  frozen_ = static_cast<int>(std::count_if(robots_.begin(), robots_.end(), [](const Robot& r) { return r.frozen; }));
}

}  // namespace murosimf
