#pragma once

/// @file Standing up as key frames; both sides of the body move alike.
///
/// front    3.88 s: fold the arms, push the trunk up, pull the feet under it, push the centre of mass over the toes,
///          squat, rise.
/// back     6.68 s: a backward roll over the head onto the front, then as from the front.
/// flank    .80 s: both arms reach behind the back, and the lower one tips the body over, nearly always onto its front;
///          there this ends. Good for either flank: the arm that lies above does no harm.
/// No feedback. Found by hand from the geometry of the robot and checked in multibody simulations: it takes arms of
/// .23 m. Before the push of `front` the shoulders are at -40 deg, not at -60 deg as first found: with the hands that
/// far from the feet they have to slide while they push. Dry friction lets them, with mu from .25 to 1; viscous
/// friction, which holds the harder the faster they slide, never did.

#include <vector>

#include "fall_detector.h"
#include "key_frame_player.h"

namespace murosimf::controllers {

/// @param walk_ready  posture in which front and back end
std::vector<KeyFrame> getUpFrames(LyingSide side, const JointAngles& walk_ready);

}  // namespace murosimf::controllers
