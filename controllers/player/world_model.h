#pragma once

/// @file What the player believes: where it stands and where the ball is.

#include "ball_model.h"
#include "localisation.h"
#include "team_ball.h"
