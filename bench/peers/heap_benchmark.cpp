// A heap of ten fallen robots: the product's whole frame, contacts among robots included, against MuJoCo's.
//
// Ours falls and settles; MuJoCo takes over positions at rest, settles too, and both hold the heap while they are
// measured.

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "heap_benchmark.h"
#include "modules/motion_world.h"
#include "paired_ratio.h"
#include "peers/mujoco_heap.h"
#include "simulated_robots.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 151;
constexpr std::size_t kRobots = 10;
constexpr double kFall = 6, kSettled = 2;  // [s]
constexpr double kAlike = 0.2;             // largest difference of contacts, share of the larger number
constexpr double kContactTime = 0.05;  // [s] of MuJoCo's contacts: with its own 0.02 they are much harder than our turf

/// Robots above one another, each turned another way; they fall on one another.
class OurHeap {
 public:
  explicit OurHeap(int lanes) : robots_("[ball]\npresent = false\n", places(), lanes) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      const double n = static_cast<double>(i);
      robots_.put(i, {rotationExp(Vector3{n, 0.5 * static_cast<double>(i % 3), 0}),
                      {0.05 * static_cast<double>(i % 3), 0.04 * static_cast<double>(i % 4), 0.4 + 0.5 * n}});
    }
    robots_.settle(kFall);
  }
  SimulatedRobots& robots() { return robots_; }
  peers::HeapRest rest() {
    robots_.requireNumbers();
    peers::HeapRest rest;
    for (std::size_t i = 0; i < kRobots; ++i) {
      const peers::PeerState state = robots_.state(i);
      peers::addGroundContacts(motion::ks21(), static_cast<int>(i), state, rest);
      rest.kinetic_energy += peers::kineticEnergy(motion::ks21(), state);
    }
    const FrameContacts& frame = robots_.simulation().pairs().contacts();
    const auto bodyOf = [&](const ContactSide& side) {
      const ContactPartner& partner = frame.partners[static_cast<std::size_t>(side.partner)];
      return peers::PeerBody{partner.responder, partner.body};
    };
    for (const ContactPair& pair : frame.pairs) rest.add(bodyOf(pair.a), bodyOf(pair.b), pair.contact.depth);
    return rest;
  }

 private:
  /// Far from one another and from the goals, until they are put elsewhere.
  static std::vector<PlanarPose> places() {
    std::vector<PlanarPose> poses;
    for (std::size_t i = 0; i < kRobots; ++i)
      poses.push_back({0.8 * static_cast<double>(i % 5) - 1.6, i < 5 ? -1.0 : 1.0, 0});
    return poses;
  }
  SimulatedRobots robots_;
};

/// Takes over how ours lies.
class TheirHeap {
 public:
  explicit TheirHeap(SimulatedRobots& ours)
      : heap_({.robot = motion::ks21(),
               .surfaces = ours.surfaces(),
               .robots = static_cast<int>(kRobots),
               .contact_time = kContactTime}),
        posture_(ours.posture()),
        sensors_(kRobots, peers::PeerSensors(motion::ks21())) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      peers::PeerState state = ours.state(i);
      state.V_B = {};
      state.dq.assign(state.dq.size(), 0.0);
      heap_.set(i, state);
    }
    for (int i = 0; i < kSettled / 1e-3; ++i) frame();
  }
  void frame() {
    heap_.command(posture_);
    heap_.step();
    for (std::size_t i = 0; i < kRobots; ++i) heap_.read(i, sensors_[i]);
  }
  peers::HeapRest rest() const {
    heap_.requireNoWarning();
    peers::HeapRest rest;
    heap_.addContacts(rest);
    for (std::size_t i = 0; i < kRobots; ++i)
      rest.kinetic_energy += peers::kineticEnergy(motion::ks21(), heap_.state(i));
    return rest;
  }

 private:
  peers::MujocoHeap heap_;
  std::vector<double> posture_;
  std::vector<peers::PeerSensors> sensors_;
};

void requireAlike(const peers::HeapRest& ours, const peers::HeapRest& theirs) {
  const auto alike = [](auto a, auto b) {
    const double more = static_cast<double>(std::max(a, b)), fewer = static_cast<double>(std::min(a, b));
    return more > 0 && more - fewer <= kAlike * more;
  };
  if (alike(ours.pairs.size(), theirs.pairs.size()) && alike(ours.points, theirs.points)) return;
  throw std::runtime_error(
      fmt::format("heap_vs_mujoco: {} pairs of bodies touch at {} points in ours, {} at {} in theirs, expected "
                  "differences of {:.0f} % at most",
                  ours.pairs.size(), ours.points, theirs.pairs.size(), theirs.points, 100 * kAlike));
}

std::string described(const peers::HeapRest& rest) {
  return fmt::format("{} pairs of bodies touch at {} points, {:.2g} mm deep at most, {:.1e} J", rest.pairs.size(),
                     rest.points, 1e3 * rest.deepest, rest.kinetic_energy);
}

}  // namespace

std::vector<Row> heapAgainstMujoco() {
  std::deque<OurHeap> heaps;
  std::vector<std::function<void()>> frames;
  for (const int lanes : laneWidths()) {
    SimulatedRobots& robots = heaps.emplace_back(lanes).robots();
    frames.emplace_back([&robots] { robots.frame(); });
  }
  TheirHeap peer(heaps.front().robots());
  const auto results = compareFrames(
      frames, [&peer] { peer.frame(); }, kRounds);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const peers::HeapRest ours = heaps[i].rest(), theirs = peer.rest();
    requireAlike(ours, theirs);
    Row& row = rows.emplace_back(Row{"heap_vs_mujoco", results[i].ratio, 1 / results[i].ours, 1 / results[i].peer,
                                     "frames/s", isaOf(laneWidths()[i]), ""});
    row.text = fmt::format("{:28} {:7} {:6.1f} times MuJoCo {} ({:.0f}, {:.0f} frames a second); ours: {}; theirs: {}",
                           row.name, row.isa, row.ratio, mj_versionString(), row.ours, row.peer, described(ours),
                           described(theirs));
  }
  return rows;
}

}  // namespace murosimf::bench
