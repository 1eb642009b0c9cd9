#pragma once

/// @file Where players without the ball stand. All in F.

#include "situation.h"

namespace murosimf::controllers {

/// Where a player waits as long as nobody knows where the ball is. @param wing  1 left, -1 right, 0 the middle
Point homePlace(const Pitch& pitch, Role role, int wing = 0);

/// Between ball and goal, on an arc before the goal: from there the goal looks narrowest to the ball.
Point keeperPlace(const Pitch& pitch, const Point& ball_F);

/// In the way of an opponent's kick, far enough from the ball to stop what comes.
Point blockPlace(const Pitch& pitch, const Point& ball_F);

/// Is the ball near enough to the own goal that the keeper clears it? `margin` [m] widens the zone.
bool inKeeperZone(const Pitch& pitch, const Point& ball_F, double margin);

/// Where a field player stands while a team mate plays the ball: the defender behind the ball on the way to the own
/// goal, the striker where a kick towards the goal attacked ends; players of a wing beside that. Never within .7 m of
/// the ball.
Point supportPlace(const Pitch& pitch, Role role, const Point& ball_F, const Point& own_F, int wing = 0);

}  // namespace murosimf::controllers
