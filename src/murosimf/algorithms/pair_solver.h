#pragma once

/// @file The pair phase: free bodies advance by one frame against everything that they may touch, and what recoils gets
/// its impulses.
///
/// Per group of free bodies and robots that touch one another the frame is cut into n substeps of h = dt/n,
/// n = ceil(dt sqrt(s_c W) / 0.35) over the contacts of free bodies that touch; 1 without free bodies. A substep:
///     1. shapes at their places at its start: depth, point, normal of every pair
///     2. velocities with gravity, held forces and last substep's impulses
///     3. sweeps of Gauss-Seidel in the order of keys: normal, tangential, turning impulse of each contact
///        (contact_law.h), until they change nothing any more
///     4. positions by h (v + v+)/2, orientation by the exponential map of the mean angular momentum
/// Points that are found at the frame's start get what they missed in the frame before (lateImpulse), and those that
/// are new between two shapes inherit from the points that these had. What recoils moves on inside the frame as its
/// response says; it gets the sum of impulses as a wrench for the frame. Results depend on names and numbers only: not
/// on the order of input, on threads or on objects that do not touch. Cost: about 1 us per contact that touches and
/// substep, 0.15 us per pair that does not; no allocation within what was reserved.

#include <memory>

#include "murosimf/algorithms/contact_frame.h"

namespace murosimf {

class IslandSolver;

class PairSolver {
 public:
  struct Settings {
    int sweeps = 4;
    double settled = 1e-5;          ///< fewer sweeps, where impulses change by less than this share of the largest one
    double largest_phase = 0.35;    ///< of w h; restitution is then within 2 %
    int most_substeps = 256;        ///< per frame
    double separation_speed = 0.5;  ///< [m/s] at most, of bodies that a teleport put into one another
    double overlap_tolerance = 2e-3;  ///< [m] of depth gained between two frames that counts as a teleport
  };

  PairSolver();
  explicit PairSolver(const Settings& settings);
  ~PairSolver();
  PairSolver(PairSolver&&) noexcept;
  PairSolver& operator=(PairSolver&&) noexcept;

  /// Room for frames of up to so many bodies and pairs.
  void reserve(int bodies, int pairs);
  /// Moves frame.bodies to the end of the frame, fills every `out` of frame (overwriting) and the kept contacts.
  void advance(FrameContacts& frame, double dt);

  /// Contacts remembered for the next frame, sorted by key.
  std::span<const KeptContact> kept() const { return kept_; }
  /// Replaces them, as at the loading of a checkpoint. @param kept sorted by key
  void restore(std::span<const KeptContact> kept) { kept_.assign(kept.begin(), kept.end()); }

 private:
  void sortByKey(std::vector<ContactPair>& pairs);
  void recall(FrameContacts& frame);
  static void sumPartners(FrameContacts& frame);

  std::vector<KeptContact> kept_;
  std::vector<KeptContact> recalled_;  // one per pair of the frame
  std::vector<int> order_;             // of the frame's pairs
  std::vector<ContactPair> sorted_;
  std::unique_ptr<IslandSolver> islands_;
};

}  // namespace murosimf
