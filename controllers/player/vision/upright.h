#pragma once

/// @file Measuring one upright cylinder in full resolution: azimuths of both edges, foot, distance.

#include "player/vision/bars.h"
#include "player/vision/uncertainty.h"

namespace murosimf::controllers {

/// A post or pole as measured. Azimuths and distances are seen from the camera, in R's axes.
struct Upright {
  double azimuth = 0;  ///< of the axis [rad]
  double azimuth_deviation = 0;
  Estimate distance{0, 1e9};  ///< horizontal, to the axis [m]
  bool foot_seen = false;
  double half_width = 0;                      ///< [pixels]
  PixelPoint lowest, highest;                 ///< ends of the middle line
  Colour below = Colour::kOther;              ///< what the middle line ends at
  bool goes_on_above = false;                 ///< in the same colour, as a post does into its crossbar
  bool cut_below = false, cut_above = false;  ///< by the border of the picture
};

/// What bars are measured in.
struct Sight {
  const PictureView& view;
  const ColourGrid& grid;
  const BarChainer& chainer;
};

/// @param bars   from top to bottom; at most three
/// @param radius of the cylinder [m]
/// @return nothing if neither the width nor the foot can be measured, or if they contradict each other
std::optional<Upright> measureUpright(const Sight& sight, std::span<const Bar* const> bars, double radius);

/// Middles of the first and the last run of a bar, in the picture.
PixelPoint topOf(const ColourGrid& grid, const Bar& bar);
PixelPoint bottomOf(const ColourGrid& grid, const Bar& bar);

/// Tangent of the elevation of the ray through this pixel.
double slopeAt(const PictureView& view, const PixelPoint& pixel);

/// Height above the ground at which the upright shows in this pixel [m].
double heightAt(const PictureView& view, const Upright& upright, const PixelPoint& pixel);

}  // namespace murosimf::controllers
