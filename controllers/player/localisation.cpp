#include "localisation.h"

#include <algorithm>
#include <cmath>

namespace murosimf::controllers {
namespace {

constexpr double kFalseShare = 0.1;      // f: share of percepts that belong to nothing on the map
constexpr double kFalseSight = 0.03;     // u: density of false landmarks [1/(rad m)], about 1 / (2 pi 5 m)
constexpr double kFalseLine = 1.0;       // u: density of the offset of false line points [1/m]
constexpr double kGate = 12;             // squared error beyond which a landmark is not believed (2 dof, 99.7 %)
constexpr double kLineGate = 7;          // the same for the offset of a line point (1 dof, 99 %)
constexpr double kAmbiguity = 4;         // squared error by which the second best name must be worse
constexpr double kDoubtStep = 0.3;       // weight of one sight in the running share of failures
constexpr double kDoubtful = 0.4;        // share above which new hypotheses are sought: two failures in a row
constexpr double kLost = 0.65;           // share above which one landmark and lines must do: three in a row
constexpr double kLostPosition = 1.5;    // what a doubtful estimate claims at most, besides [m]
constexpr double kLostHeading = 1.0;     // [rad]
constexpr double kEntryWeight = -10;     // logarithm of the weight of a new hypothesis against the best
constexpr double kOutsideWeight = -3;    // the same, on top, where it is outside the lines: robots seldom are
constexpr double kSmallestWeight = -16;  // below it a hypothesis is dropped
constexpr double kBearingSway = 0.015;   // of landmarks, beside the deviation that vision claims [rad]
constexpr double kDistanceSway = 0.03;   // the same, per metre of distance
constexpr double kFarthest = 15;         // no field is seen farther [m]
constexpr double kLargestTurn = 100;     // of a heading that somebody tells [rad]

bool plausible(const LandmarkPercept& percept) {
  return std::isfinite(percept.bearing) && percept.distance > 0.05 && percept.distance < kFarthest &&
         percept.bearing_deviation >= 0 && percept.bearing_deviation < 10 && percept.distance_deviation >= 0 &&
         percept.distance_deviation < 100;
}

/// What vision claims, plus what it cannot know: sway of the body under the camera.
LandmarkSight sightOf(LandmarkKind kind, const LandmarkPercept& percept) {
  const double bearing = percept.bearing_deviation, distance = percept.distance_deviation;
  const double sway = kDistanceSway * percept.distance;
  return {kind,
          percept.colour,
          wrapAngle(percept.bearing),
          percept.distance,
          bearing * bearing + kBearingSway * kBearingSway,
          distance * distance + 4e-4 + sway * sway};
}

}  // namespace

void Localisation::start(const client::RobotDescription& robot) {
  map_.start(robot);
  memory_.clear();
  count_ = 1;
  beliefs_[0] = PoseBelief::at(map_.middleOfOwnHalf(), 1.5, 1.5);
  beliefs_[0].doubt = 1;
}

void Localisation::place(const PlanarPose& pose) {
  const bool plausible = std::fabs(pose.x) + std::fabs(pose.y) < kFarthest && std::fabs(pose.heading) < kLargestTurn;
  if (!plausible) return;
  memory_.clear();
  count_ = 1;
  beliefs_[0] = PoseBelief::at(pose, 0.05, 0.05);
}

void Localisation::move(const PlanarPose& increment) {
  if (!(std::fabs(increment.x) + std::fabs(increment.y) + std::fabs(increment.heading) < 10)) return;
  for (PoseBelief& belief : std::span(beliefs_).first(count_)) belief.move(increment);
  memory_.move(increment);
}

void Localisation::widen(double position_deviation, double heading_deviation) {
  for (PoseBelief& belief : std::span(beliefs_).first(count_)) belief.widen(position_deviation, heading_deviation);
}

void Localisation::observe(const Percepts& percepts) {
  const LineSights lines(percepts.lines);
  for (const LandmarkPercept& post : percepts.posts) observeLandmark(LandmarkKind::kPost, post, lines);
  for (const LandmarkPercept& pole : percepts.poles) observeLandmark(LandmarkKind::kPole, pole, lines);
  for (PoseBelief& belief : std::span(beliefs_).first(count_)) judge(belief, lines);
  tidy();
}

void Localisation::observeLandmark(LandmarkKind kind, const LandmarkPercept& percept, const LineSights& lines) {
  if (!plausible(percept) || map_.landmarks(kind, percept.colour).empty()) return;
  const LandmarkSight sight = sightOf(kind, percept);
  for (PoseBelief& belief : std::span(beliefs_).first(count_)) judge(belief, sight);
  if (beliefs_[0].doubt > kDoubtful) propose(sight, lines);
  memory_.add(sight);
}

void Localisation::judge(PoseBelief& belief, const LandmarkSight& sight) const {
  const std::span<const Point> landmarks = map_.landmarks(sight.kind, sight.colour);
  PolarInnovation nearest;
  double second = 1e9, density = 0;
  nearest.squared_error = 1e9;
  for (const Point& landmark : landmarks) {
    const PolarInnovation innovation = belief.compare(sight, landmark);
    density += innovation.density;
    second = std::min(second, std::max(nearest.squared_error, innovation.squared_error));
    if (innovation.squared_error < nearest.squared_error) nearest = innovation;
  }
  const double share = (1 - kFalseShare) / static_cast<double>(landmarks.size());
  belief.log_weight += log(share * density + kFalseShare * kFalseSight);
  const bool explained = nearest.squared_error < kGate;
  belief.doubt += kDoubtStep * ((explained ? 0 : 1) - belief.doubt);
  if (!explained) belief.widen(0.03, 0.03);
  if (explained && (landmarks.size() < 2 || second > nearest.squared_error + kAmbiguity)) belief.correct(nearest);
}

void Localisation::judge(PoseBelief& belief, const LineSights& lines) const {
  double log_weight = 0;
  for (const LineSights::Sight& line : lines.sights()) {
    const SinCos<double> heading = sincos(belief.mean.heading);
    const Point lever = turned(heading, line.p_R);  // from the robot to the point, in F
    const Point seen_normal = turned(heading, {line.normal.cos, line.normal.sin});
    const LineMatch match = map_.nearestLine(Point{belief.mean.x, belief.mean.y} + lever, seen_normal);
    double density = 0;
    if (match.found) {
      const Point& n = match.normal;
      const Measurement offset{{n.x, n.y, n.y * lever.x - n.x * lever.y}, -match.offset, line.variance};
      const double S = belief.innovationVariance(offset), squared = match.offset * match.offset / S;
      density = exp(-0.5 * squared) / sqrt(2 * kPi * S);
      if (squared < kLineGate) belief.correct(offset);
    }
    log_weight += log((1 - kFalseShare) * density + kFalseShare * kFalseLine);
  }
  belief.log_weight += log_weight / lines.dependence();
}

void Localisation::propose(const LandmarkSight& sight, const LineSights& lines) {
  for (std::size_t i = 0; i < memory_.size(); ++i) enter(posesFromPair(map_, sight, memory_.sight(i)));
  if (beliefs_[0].doubt > kLost && lines.haveDirection()) enter(posesFromOne(map_, sight, lines.direction()));
}

void Localisation::enter(const PoseProposals& proposals) {
  for (const PoseBelief& belief : std::span(proposals.beliefs).first(proposals.count)) enter(belief);
}

namespace {

bool alike(const PoseBelief& a, const PoseBelief& b, double distance, double angle) {
  return norm(Point{a.mean.x - b.mean.x, a.mean.y - b.mean.y}) < distance &&
         std::fabs(wrapAngle(a.mean.heading - b.mean.heading)) < angle;
}

bool heavier(const PoseBelief& a, const PoseBelief& b) { return a.log_weight > b.log_weight; }

}  // namespace

void Localisation::enter(const PoseBelief& proposal) {
  double best = beliefs_[0].log_weight;
  std::size_t weakest = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (alike(beliefs_[i], proposal, 0.3, 0.25)) return;
    best = std::max(best, beliefs_[i].log_weight);
    if (beliefs_[i].log_weight < beliefs_[weakest].log_weight) weakest = i;
  }
  const bool outside = !map_.contains({proposal.mean.x, proposal.mean.y}, 0.1);
  const double weight = best + kEntryWeight + (outside ? kOutsideWeight : 0);
  const std::size_t place = count_ < kCapacity ? count_ : weakest;
  if (place == weakest && beliefs_[weakest].log_weight > weight) return;
  beliefs_[place] = proposal;
  beliefs_[place].log_weight = weight;
  count_ = std::max(count_, place + 1);
}

void Localisation::tidy() {
  const auto first = beliefs_.begin();
  for (auto next = first; next != first + static_cast<std::ptrdiff_t>(count_); ++next)  // insertion sort, stable
    std::rotate(std::upper_bound(first, next, *next, heavier), next, next + 1);
  const double best = beliefs_[0].log_weight;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    PoseBelief belief = beliefs_[i];
    belief.log_weight -= best;
    bool dropped = belief.log_weight < kSmallestWeight;
    for (std::size_t j = 0; j < kept; ++j) dropped = dropped || alike(beliefs_[j], belief, 0.2, 0.15);
    if (dropped) continue;
    const Point p = map_.nearestOnCarpet({belief.mean.x, belief.mean.y});
    belief.mean.x = p.x, belief.mean.y = p.y;
    beliefs_[kept++] = belief;
  }
  count_ = kept;
}

double Localisation::doubtShare() const { return std::max(0.0, (beliefs_[0].doubt - kDoubtStep) / (1 - kDoubtStep)); }

double Localisation::positionDeviation() const {
  double sum = 0, weights = 0;
  for (const PoseBelief& belief : std::span(beliefs_).first(count_)) {
    const double weight = exp(belief.log_weight);
    const double dx = belief.mean.x - beliefs_[0].mean.x, dy = belief.mean.y - beliefs_[0].mean.y;
    sum += weight * (belief.covariance[0][0] + belief.covariance[1][1] + dx * dx + dy * dy);
    weights += weight;
  }
  const double lost = kLostPosition * doubtShare();
  return sqrt(sum / weights + lost * lost);
}

double Localisation::headingDeviation() const {
  double sum = 0, weights = 0;
  for (const PoseBelief& belief : std::span(beliefs_).first(count_)) {
    const double weight = exp(belief.log_weight);
    const double difference = wrapAngle(belief.mean.heading - beliefs_[0].mean.heading);
    sum += weight * (belief.covariance[2][2] + difference * difference);
    weights += weight;
  }
  const double lost = kLostHeading * doubtShare();
  return sqrt(sum / weights + lost * lost);
}

void Localisation::archive(client::StateArchive& archive) { archive(memory_, beliefs_, count_); }

}  // namespace murosimf::controllers
