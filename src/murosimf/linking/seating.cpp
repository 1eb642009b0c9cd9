// Who sits in which lane, and how an assembly goes from one batch to another.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "murosimf/linking/linked_world.h"

namespace murosimf {

namespace {

/// A robot's numbers of one piece of memory, from or to its lane.
struct Lane {
  double* piece;
  int width, lane;
  double& operator[](std::size_t i) const {
    return piece[i * static_cast<std::size_t>(width) + static_cast<std::size_t>(lane)];
  }
};

Lane laneOf(const Batch& batch, const BlockPieces& pieces, int lane) {
  return {pieces[static_cast<std::size_t>(lane / batch.width)].data(), batch.width, lane % batch.width};
}

const LinkedPass* writerOf(const Batch& batch, const ColumnLayout* layout) {
  return layout == nullptr || layout->writer < 0 ? nullptr : &batch.passes[static_cast<std::size_t>(layout->writer)];
}

Passage passageBetween(const std::deque<Batch>& batches, int from, int to) {
  Passage passage{from, to, {}};
  const Batch &a = batches[static_cast<std::size_t>(from)], &b = batches[static_cast<std::size_t>(to)];
  for (const ColumnLayout& column : a.columns) {
    const ColumnLayout* other = b.column(column.property, column.subset);
    const bool both = column.ref.memory == MemoryKind::kState && other != nullptr &&
                      other->ref.memory == MemoryKind::kState && other->objects == column.objects &&
                      other->components == column.components;
    if (both) passage.stretches.push_back({column.ref.offset, other->ref.offset, column.objects * column.components});
  }
  return passage;
}

}  // namespace

const Resident& LinkedWorld::residentOf(ObjectId assembly) const {
  const int number = residentNumber(assembly);
  if (number >= 0) return residents_[static_cast<std::size_t>(number)];
  throw std::logic_error("an object that no module steps and nothing is attached to has no place among the batches");
}

int LinkedWorld::residentNumber(ObjectId assembly) const {
  const auto object = static_cast<std::size_t>(assembly.index);
  return assembly.valid() && object < resident_of_.size() ? resident_of_[object] : -1;
}

int LinkedWorld::levelCount(ObjectId assembly) const { return static_cast<int>(residentOf(assembly).levels.size()); }
int LinkedWorld::levelOf(ObjectId assembly) const { return residentOf(assembly).level; }

int LinkedWorld::longestPeriod(ObjectId assembly, int level) const {
  const LevelSeat& seat = residentOf(assembly).levels.at(static_cast<std::size_t>(level));
  int longest = 1;
  for (const LinkedPass& pass : batches_[static_cast<std::size_t>(seat.batch)].passes) {
    longest = std::max(longest, pass.period);
  }
  return longest;
}

const ColumnCell* LinkedWorld::watch(ObjectId assembly, std::string_view property, std::string_view of,
                                     int components) {
  static const ColumnCell nowhere;
  const int number = residentNumber(assembly);
  if (number < 0) return &nowhere;
  Resident& resident = residents_[static_cast<std::size_t>(number)];
  Watch watch{std::string(property), std::string(of), {}, {}, nullptr};
  bool known = false;
  for (const LevelSeat& seat : resident.levels) {
    const Batch& batch = batches_[static_cast<std::size_t>(seat.batch)];
    const ColumnLayout* layout = batch.column(property, of);
    if (layout != nullptr && layout->ref.memory != MemoryKind::kState) layout = nullptr;
    if (layout != nullptr && layout->components != components) {
      throw std::logic_error(fmt::format("a handle for {} numbers asks for variable {}, which has {}", components,
                                         property, layout->components));
    }
    known = known || layout != nullptr;
    watch.layouts.push_back(layout);
    watch.writers.push_back(writerOf(batch, layout));
  }
  if (!known) return &nowhere;
  for (const Watch& other : resident.watches) {
    if (other.property == property && other.subset == of) return other.cell;
  }
  watch.cell = &cells_.emplace_back();
  resident.watches.push_back(std::move(watch));
  point(resident);
  return resident.watches.back().cell;
}

/// Lets place and handles of a resident show where it is.
void LinkedWorld::point(Resident& resident) {
  const Batch& batch = batchOf(resident);
  const auto index = static_cast<std::size_t>(&resident - residents_.data());
  const Place& place =
      places_[index] = {resident.assembly, resident.batch(), resident.lane / batch.width, resident.lane % batch.width};
  for (Watch& watch : resident.watches) {
    const auto level = static_cast<std::size_t>(resident.level);
    const ColumnLayout* layout = watch.layouts[level];
    const LinkedPass* writer = watch.writers[level];
    *watch.cell = {};
    if (layout == nullptr) continue;
    watch.cell->first = element(place, *layout);
    watch.cell->stride = batch.width;
    watch.cell->objects = layout->objects;
    if (layout->storage == Storage::kOnDemand)
      watch.cell->answers = &batch.answers[static_cast<std::size_t>(place.block)];
    if (writer == nullptr) continue;
    watch.cell->period = writer->period;
    watch.cell->phase = writer->phase;
  }
}

/// Layouts at every level of the state columns that any level has.
std::vector<std::vector<const ColumnLayout*>> LinkedWorld::stateColumns(const Resident& resident) const {
  std::vector<std::vector<const ColumnLayout*>> columns;
  for (const LevelSeat& seat : resident.levels) {
    for (const ColumnLayout& layout : batches_[static_cast<std::size_t>(seat.batch)].columns) {
      if (layout.ref.memory != MemoryKind::kState || layout.storage != Storage::kState) continue;
      std::vector<const ColumnLayout*> of_levels;
      for (const LevelSeat& other : resident.levels) {
        const ColumnLayout* same =
            batches_[static_cast<std::size_t>(other.batch)].column(layout.property, layout.subset);
        const bool state = same != nullptr && same->storage == Storage::kState && same->objects == layout.objects &&
                           same->components == layout.components;
        of_levels.push_back(state ? same : nullptr);
      }
      if (std::find(columns.begin(), columns.end(), of_levels) == columns.end())
        columns.push_back(std::move(of_levels));
    }
  }
  return columns;
}

/// Called once, when all batches are linked: remembers what every level of every resident begins with.
void LinkedWorld::finishSeating() {
  places_.resize(residents_.size());
  std::size_t state = 1, step = 1, own = 1;
  for (Batch& batch : batches_) {
    state = std::max(state, batch.state_size), step = std::max(step, batch.step_size),
    own = std::max(own, batch.own_size);
    batch.shared_one = AlignedDoubles(batch.shared.size() / static_cast<std::size_t>(batch.width));
    for (std::size_t i = 0; i < batch.shared_one.size(); ++i) {
      batch.shared_one.data()[i] = batch.shared.data()[i * static_cast<std::size_t>(batch.width)];
    }
  }
  state_one_ = AlignedDoubles(state), step_one_ = AlignedDoubles(step), own_one_ = AlignedDoubles(own);
  left_ = AlignedDoubles(state);
  for (std::size_t i = 0; i < residents_.size(); ++i) {
    const auto object = static_cast<std::size_t>(residents_[i].assembly.index);
    if (resident_of_.size() <= object) resident_of_.resize(object + 1, -1);
    resident_of_[object] = static_cast<int>(i);
  }
  for (Resident& resident : residents_) {
    for (LevelSeat& seat : resident.levels) {
      const Batch& batch = batches_[static_cast<std::size_t>(seat.batch)];
      const auto member =
          std::find(batch.members.begin(), batch.members.end(), resident.assembly) - batch.members.begin();
      const Lane first = laneOf(batch, batch.state, static_cast<int>(member)),
                 owned = laneOf(batch, batch.own, static_cast<int>(member));
      for (std::size_t i = 0; i < batch.state_size; ++i) seat.fresh.push_back(first[i]);
      for (std::size_t i = 0; i < batch.own_size; ++i) seat.own.push_back(owned[i]);
      for (const LevelSeat& other : resident.levels) {
        const bool same = std::any_of(passages_.begin(), passages_.end(),
                                      [&](const Passage& p) { return p.from == seat.batch && p.to == other.batch; });
        if (&other != &seat && !same) passages_.push_back(passageBetween(batches_, seat.batch, other.batch));
      }
    }
    resident.columns = stateColumns(resident);
    point(resident);
  }
}

/// The last one of the batch takes the lane that becomes free.
void LinkedWorld::leave(Resident& resident) {
  Batch& batch = batchOf(resident);
  std::vector<int>& seats = seats_[static_cast<std::size_t>(resident.batch())];
  const int last = --batch.seated;
  if (last == resident.lane) return;
  const Lane from = laneOf(batch, batch.state, last), to = laneOf(batch, batch.state, resident.lane);
  for (std::size_t i = 0; i < batch.state_size; ++i) to[i] = from[i];
  const Lane own_from = laneOf(batch, batch.own, last), own_to = laneOf(batch, batch.own, resident.lane);
  for (std::size_t i = 0; i < batch.own_size; ++i) own_to[i] = own_from[i];
  const int moved = seats[static_cast<std::size_t>(last)];
  seats[static_cast<std::size_t>(resident.lane)] = moved;
  residents_[static_cast<std::size_t>(moved)].lane = resident.lane;
  point(residents_[static_cast<std::size_t>(moved)]);
  forgetAnswers(places_[static_cast<std::size_t>(moved)]);
}

/// Takes the next lane of the level's batch, with the state that stands in state_one_.
void LinkedWorld::enter(Resident& resident, int level) {
  resident.level = level;
  Batch& batch = batchOf(resident);
  resident.lane = batch.seated++;
  const LevelSeat& seat = resident.levels[static_cast<std::size_t>(level)];
  const Lane state = laneOf(batch, batch.state, resident.lane), own = laneOf(batch, batch.own, resident.lane);
  for (std::size_t i = 0; i < batch.state_size; ++i) state[i] = state_one_.data()[i];
  for (std::size_t i = 0; i < batch.own_size; ++i) own[i] = seat.own[i];
  seats_[static_cast<std::size_t>(resident.batch())][static_cast<std::size_t>(resident.lane)] =
      static_cast<int>(&resident - residents_.data());
  point(resident);
  forgetAnswers(placeOf(resident));
}

void LinkedWorld::beginAnew(ObjectId assembly) {
  const Resident& resident = residentOf(assembly);
  const LevelSeat& seat = resident.levels[static_cast<std::size_t>(resident.level)];
  const Batch& batch = batchOf(resident);
  const Lane state = laneOf(batch, batch.state, resident.lane);
  for (std::size_t i = 0; i < batch.state_size; ++i) state[i] = seat.fresh[i];
  forgetAnswers(placeOf(resident));
}

void LinkedWorld::exchange(ObjectId assembly, int level) {
  auto& resident = const_cast<Resident&>(residentOf(assembly));
  if (level < 0 || level >= static_cast<int>(resident.levels.size())) {
    throw std::invalid_argument(fmt::format("level of detail {}; expected one of the {} with which it was linked",
                                            level, resident.levels.size()));
  }
  if (level == resident.level) return;
  const Batch& source = batchOf(resident);
  const Lane before = laneOf(source, source.state, resident.lane);
  for (std::size_t i = 0; i < source.state_size; ++i) left_.data()[i] = before[i];
  const LevelSeat& seat = resident.levels[static_cast<std::size_t>(level)];
  std::copy(seat.fresh.begin(), seat.fresh.end(), state_one_.data());
  std::copy(seat.own.begin(), seat.own.end(), own_one_.data());
  const auto passage = std::find_if(passages_.begin(), passages_.end(),
                                    [&](const Passage& p) { return p.from == resident.batch() && p.to == seat.batch; });
  for (const Passage::Stretch& stretch : passage->stretches) {
    std::copy_n(left_.data() + stretch.from, stretch.numbers, state_one_.data() + stretch.to);
  }
  const Batch& target = batches_[static_cast<std::size_t>(seat.batch)];
  const BlockMemory one{{state_one_.data(), step_one_.data(), target.shared_one.data(), own_one_.data()}};
  for (const LinkedPass& pass : target.passes) pass.module->adopt(one);
  leave(resident);
  enter(resident, level);
}

}  // namespace murosimf
