#include "murosimf/simulation/recording_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/simulation/recording_reader.h"

namespace murosimf {

RecordingPlayer::RecordingPlayer(const std::filesystem::path& file, Simulation& simulation, long stride)
    : file_(file), simulation_(simulation) {
  read(std::max(1L, stride));
  LinkedWorld& linked = simulation.linked();
  for (const ObjectId id : simulation.participants().robots) {
    const Robot robot{&linked.residentOf(id),
                      linked.handle(id, kBasePose),
                      linked.handle(id, kShownBase),
                      linked.handle(id, kShownBaseLast),
                      linked.handle(id, kJointPosition, subset::kJoints),
                      linked.handle(id, kShownPosition, subset::kJoints),
                      linked.handle(id, kShownPositionLast, subset::kJoints)};
    if (robot.shown_base.valid()) robots_.push_back(robot);
  }
}

void RecordingPlayer::read(long stride) {
  RecordingReader reader(file_);
  header_ = reader.header();
  const auto known = [&](const RecordedGroup& group) { return simulation_.world().find(group.assembly).valid(); };
  if (std::none_of(header_.groups.begin(), header_.groups.end(), known)) {
    throw std::runtime_error(fmt::format("{}: nothing of what was recorded (scenario {}) is in this world",
                                         file_.string(), header_.scenario));
  }
  while (reader.next()) {
    if ((reader.frame() - header_.first_frame) % stride != 0) continue;
    times_.push_back(reader.time());
    std::vector<double>& state = states_.emplace_back();
    for (const RecordedColumn& column : header_.columns) {
      const auto numbers = reader.numbers(column);
      state.insert(state.end(), numbers.begin(), numbers.end());
    }
  }
  if (times_.empty()) throw std::runtime_error(fmt::format("{}: no frame was recorded", file_.string()));
}

/// The recorded column of a column of the world; null when there is none.
const RecordedColumn* RecordingPlayer::columnOf(const Place& place, const ColumnLayout& layout) const {
  const std::string& assembly = simulation_.world().path(place.assembly);
  const auto same = [&](const RecordedColumn& column) {
    const RecordedGroup& group = header_.groupOf(column);
    return group.assembly == assembly && group.subset == layout.subset && column.property == layout.property &&
           static_cast<int>(column.components) == layout.components &&
           static_cast<int>(group.members.size()) == layout.objects;
  };
  const auto found = std::find_if(header_.columns.begin(), header_.columns.end(), same);
  return found == header_.columns.end() ? nullptr : &*found;
}

void RecordingPlayer::fill(const Place& place, const std::vector<double>& state) {
  const ColumnLayout* of = nullptr;
  const RecordedColumn* column = nullptr;
  const auto write = [&](const ColumnLayout& layout, int object, int component, double& value) {
    if (&layout != of) column = columnOf(place, layout);
    of = &layout;
    const auto offset = static_cast<std::size_t>(object * layout.components + component);
    if (column != nullptr) value = state[column->first + offset];
  };
  simulation_.linked().visitState(place, write);
}

/// At the end of the step and at its beginning alike: bodies stand still between two states.
void RecordingPlayer::placeBodies(Robot& robot) {
  for (Handle<Pose>* base : {&robot.shown_base, &robot.shown_base_last}) base->set(robot.base.get());
  for (Handle<double>* q : {&robot.shown_q, &robot.shown_q_last}) {
    for (int j = 0; j < q->size(); ++j) q->set(robot.q.get(j), j);
  }
  simulation_.linked().forgetAnswers(simulation_.linked().placeOf(*robot.resident));
}

void RecordingPlayer::show(double time) {
  const auto later = std::upper_bound(times_.begin(), times_.end(), time + 1e-9);
  shown_ = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, later - times_.begin()) - 1);
  for (const Place& place : simulation_.linked().places()) fill(place, states_[shown_]);
  for (Robot& robot : robots_) placeBodies(robot);
}

}  // namespace murosimf
