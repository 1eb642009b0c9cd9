#include "murosimf/simulation/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "murosimf/simulation/bitmap_font.h"

namespace murosimf {
namespace {

constexpr Rgb kInk{250, 20, 30};

/// A black picture, and what is not black in it.
struct Sheet {
  Picture picture;
  Canvas canvas{picture};
  Sheet(int width, int height) {
    picture.has_depth = picture.has_label = false;
    picture.resize(width, height);
  }
  Rgb at(int u, int v) const {
    const std::uint8_t* p = &picture.rgb[3 * picture.index(u, v)];
    return {p[0], p[1], p[2]};
  }
  std::set<std::pair<int, int>> drawn() const {
    std::set<std::pair<int, int>> places;
    for (int v = 0; v < picture.height; ++v)
      for (int u = 0; u < picture.width; ++u)
        if (at(u, v) != Rgb{0, 0, 0}) places.insert({u, v});
    return places;
  }
};

TEST(Canvas, LineHasOnePixelAColumnOrRowAndStaysWithinHalfAPixel) {
  for (const auto& [du, dv] : {std::pair{13, 4}, {4, 13}, {-9, 9}, {0, 7}, {-11, 0}, {3, -14}}) {
    Sheet s(40, 40);
    s.canvas.line({20, 20}, {20.0 + du, 20.0 + dv}, kInk);
    const auto places = s.drawn();
    EXPECT_EQ(places.size(), static_cast<std::size_t>(std::max(std::abs(du), std::abs(dv)) + 1));
    EXPECT_TRUE(places.count({20, 20}) == 1 && places.count({20 + du, 20 + dv}) == 1);
    const double length = std::hypot(du, dv);
    for (const auto& [u, v] : places) EXPECT_LE(std::fabs((u - 20) * dv - (v - 20) * du) / length, 0.5 + 1e-9);
  }
}

TEST(Canvas, CircleIsClosedAndHasItsRadius) {
  for (const double radius : {1.0, 4.3, 17.0, 30.5}) {
    Sheet s(80, 80);
    s.canvas.circle({40, 40}, radius, kInk);
    const auto places = s.drawn();
    for (const auto& [u, v] : places) EXPECT_NEAR(std::hypot(u - 40, v - 40), radius, 0.75);
    for (double angle = 0; angle < 6.28; angle += 0.02) {
      const double u = 40 + radius * std::cos(angle), v = 40 + radius * std::sin(angle);
      bool near = false;
      for (const auto& [pu, pv] : places) near = near || std::hypot(pu - u, pv - v) < 1.01;
      EXPECT_TRUE(near) << radius << " " << angle;
    }
  }
}

TEST(Canvas, WhatLiesOutsideIsCutOffAndWhatIsNoNumberIsNotDrawn) {
  Sheet s(16, 12);
  s.canvas.line({-100, 5}, {100, 5}, kInk);
  EXPECT_EQ(s.drawn().size(), 16U);
  Sheet empty(16, 12);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -1e300}) {
    empty.canvas.line({bad, 0}, {5, 5}, kInk);
    empty.canvas.circle({5, 5}, bad, kInk);
    empty.canvas.circle({5, bad}, 3, kInk);
    empty.canvas.fill({bad, 0}, {5, 5}, kInk);
    empty.canvas.label({bad, 0}, "X", kInk);
  }
  empty.canvas.circle({500, 500}, 20, kInk);
  empty.canvas.text(-50, 3, "ABC", kInk);
  EXPECT_TRUE(empty.drawn().empty());
}

TEST(Canvas, RectangleIsItsOutlineAndFillMixes) {
  Sheet s(20, 20);
  s.canvas.rectangle({12, 9}, {3, 4}, kInk);
  EXPECT_EQ(s.drawn().size(), 2U * 10 + 2 * 4);
  s.canvas.fill({0, 0}, {1, 1}, {200, 100, 0}, 0.5);
  EXPECT_EQ(s.at(1, 1), (Rgb{100, 50, 0}));
  EXPECT_EQ(s.at(2, 1), (Rgb{0, 0, 0}));
}

TEST(Canvas, TextShowsTheGlyphsDotByDotAtEveryScale) {
  const std::string words = "R2:9";
  for (const int scale : {1, 2, 3}) {
    Sheet s(120, 40);
    s.canvas.text(5, 6, words, kInk, scale);
    for (int u = 0; u < Canvas::textWidth(words, scale); ++u)
      for (int v = 0; v < Canvas::textHeight(scale); ++v) {
        const int dot = u / scale;
        const int column = dot % (kGlyphWidth + 1);
        const Glyph& glyph = glyphOf(words[static_cast<std::size_t>(dot / (kGlyphWidth + 1))]);
        const bool ink =
            column < kGlyphWidth && (glyph[static_cast<std::size_t>(v / scale)] >> (kGlyphWidth - 1 - column) & 1) != 0;
        EXPECT_EQ(s.at(5 + u, 6 + v) == kInk, ink) << u << " " << v;
      }
  }
}

TEST(Canvas, LabelsStayInThePicture) {
  for (const auto& [u, v] : {std::pair{-30.0, -30.0}, {100.0, 50.0}, {63.0, -2.0}}) {
    Sheet s(64, 24), whole(64, 24);
    s.canvas.label({u, v}, "POST", kInk);
    whole.canvas.text(10, 10, "POST", kInk);
    std::size_t ink = 0;
    for (const auto& [x, y] : s.drawn()) ink += s.at(x, y) == kInk ? 1U : 0U;
    EXPECT_EQ(ink, whole.drawn().size());
  }
}

TEST(BitmapFont, EveryCharacterThatCaptionsUseHasAGlyphOfItsOwn) {
  const std::string used = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ .,:-+/%()=!?_#'";
  std::set<Glyph> glyphs;
  for (const char character : used) glyphs.insert(glyphOf(character));
  EXPECT_EQ(glyphs.size(), used.size());
  EXPECT_EQ(glyphs.count(glyphOf('~')), 0U);  // what it lacks is none of them
  EXPECT_EQ(glyphOf('q'), glyphOf('Q'));
  EXPECT_EQ(glyphOf('\xe4'), glyphOf('~'));
}

}  // namespace
}  // namespace murosimf
