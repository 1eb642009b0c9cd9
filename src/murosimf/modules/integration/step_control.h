#pragma once

/// @file How long the steps of one robot are, which of them count, and where its forces jump.
///
/// Length     A step whose estimated error is err tolerances counts when err <= 1; the next one is as long as
///                h+ = h clamp(0.9 err^(-1/5), 0.2, 5)          [Hairer, Norsett, Wanner 1993, II.4]
///            would have it, not longer than before after one that did not count, and so that equal steps fill what is
///            left of the frame. A step of the least length counts in any case, unless it is no number.
/// Events     A jump inside a step spoils its estimate and would be approached in ever smaller steps. Where an event
///            function changes its sign in a step, wherever its error, the step is made again so that it ends shortly
///            before; its path, which has seen no jump, is followed beyond its end to the change of sign, found by
///            false position with the Illinois rule [Dowell, Jarratt 1971], and the next step begins just behind it.
///            Two events of one robot stand at least `event_distance` apart: what changes sign sooner again, as a body
///            at rest may, is left to the error alone.
/// Faults     A robot of which even the least step gives no number, or that has made `most_rounds` rounds, stops where
///            it is, before the end of its frame, and says so.
///
/// All numbers are of one robot: it takes the same decisions alone and in lanes.

namespace murosimf {

/// Of the method; the same for all robots of a batch.
struct StepLimits {
  double tolerance = 1e-6;       ///< of lengths in m, angles in rad, their rates; relative for numbers beyond 1
  double least_step = 1e-12;     ///< [s]
  double most_rounds = 1000;     ///< steps tried in a frame
  double event_distance = 1e-5;  ///< [s]
  bool locates_events = true;
};

/// S: double, or a pack with a robot in each lane.
template <class S = double>
struct StepControl {
  // What kernels ask.
  S active;     ///< 1 while the robot has not reached the end of its frame
  S h;          ///< length of the step that is tried [s]
  S moved;      ///< 1: the state that is there now counts; 0: it goes back to that at the beginning of the step
  S searching;  ///< 1: the robot is placed at theta of its path
  S theta;      ///< 1: end of the step
  // What kernels answer.
  S error;        ///< err: largest estimated error of any coordinate, in tolerances
  S watch;        ///< smallest event function, each counted positive as at the step's beginning; < 0: one has changed
  S watch_first;  ///< the same at the beginning of the step, >= 0
  S crossing;     ///< share of the step at which that happened first; beyond 1: it did not
  // What the control remembers.
  S time;                              ///< since the beginning of the frame [s]
  S step;                              ///< length that the error would have [s]
  S approach;                          ///< length that ends shortly before an event [s]; 0: no event in sight
  S rejected;                          ///< 1: the step before did not count
  S ends_frame;                        ///< 1: the step reaches the end of the frame
  S rounds, substeps, evaluations;     ///< tried, counted, forces evaluated
  S error_sum;                         ///< of the steps that counted, in tolerances
  S events, last_event;                ///< how many, and when the last one was, as `time`
  S low, high, watch_low, watch_high;  ///< of the search: no event yet at low, one at high; shares of the step
  S side, tries;                       ///< which of the two has been replaced last; places looked at
  S open;                              ///< 1: the search goes on
  S fault;                             ///< 1: the robot has stopped before the end of its frame
};

/// At the beginning of a frame of length dt. `step`: length of a step as it was good in the frame before, if positive;
/// `last_event`: when the last event was, from the frame's beginning.
void beginFrame(StepControl<>& c, double step, double last_event, double dt);
/// Chooses the next step. False when there is none any more.
bool planStep(StepControl<>& c, const StepLimits& limits, double dt);
/// After the step has been tried: does it count? True when an event is to be searched behind its end.
bool judgeStep(StepControl<>& c, const StepLimits& limits, double dt);
/// After `watch` at theta has been found: chooses the next theta. False when the search is over.
bool searchEvent(StepControl<>& c);
/// After the robot has been placed where the search ended.
void endSearch(StepControl<>& c, double dt);

}  // namespace murosimf
