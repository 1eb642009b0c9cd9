#include "murosimf/render/gl/gl_field.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "murosimf/render/gl/gl_meshes.h"

namespace murosimf {

namespace {

constexpr double kCell = 0.1, kFootprint = 0.15;  // [m]
constexpr double kFineCell = 0.04;                // of what decides about tiles [m]

/// A line or a circle as the shader reads it.
struct Mark {
  float x, y, along_x, along_y;
  float half_length, half_width, radius, unused;
};

Mark markOf(const PaintedLine& line) {
  const double dx = line.b_x - line.a_x, dy = line.b_y - line.a_y, length = std::hypot(dx, dy);
  const bool dot = length < 1e-9;
  return {static_cast<float>(0.5 * (line.a_x + line.b_x)),
          static_cast<float>(0.5 * (line.a_y + line.b_y)),
          static_cast<float>(dot ? 1 : dx / length),
          static_cast<float>(dot ? 0 : dy / length),
          static_cast<float>(0.5 * length),
          static_cast<float>(0.5 * line.width),
          0,
          0};
}
Mark markOf(const PaintedCircle& c) {
  return {static_cast<float>(c.x),           static_cast<float>(c.y),      1, 0, 0,
          static_cast<float>(0.5 * c.width), static_cast<float>(c.radius), 0};
}

std::vector<Mark> marksOf(const PaintedGround& ground) {
  std::vector<Mark> marks;
  for (const PaintedLine& line : ground.lines) marks.push_back(markOf(line));
  for (const PaintedCircle& circle : ground.circles) marks.push_back(markOf(circle));
  return marks;
}

/// True when the mark may colour a pixel whose middle lies within `reach` of the place.
bool isNear(const Mark& m, double x, double y, double reach) {
  const double dx = x - m.x, dy = y - m.y;
  if (m.radius > 0) return std::fabs(std::hypot(dx, dy) - m.radius) <= m.half_width + reach;
  return std::fabs(dx * m.along_x + dy * m.along_y) <= m.half_length + reach &&
         std::fabs(dy * m.along_x - dx * m.along_y) <= m.half_width + reach;
}

double reachOf(const Mark& m) { return m.half_length + m.half_width + m.radius; }

/// Cells over the rectangle that a mark comes into, without any footprint: tiles reach for that themselves.
MarkedCells markedCells(const std::vector<Mark>& marks, MarkedCells of) {
  const auto columns = static_cast<std::size_t>(of.columns), rows = static_cast<std::size_t>(of.rows);
  of.sums.assign((columns + 1) * (rows + 1), 0);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0, along = 0; column < columns; ++column) {
      const double x = of.low_x + (static_cast<double>(column) + 0.5) * of.edge,
                   y = of.low_y + (static_cast<double>(row) + 0.5) * of.edge;
      const bool any = std::any_of(marks.begin(), marks.end(),
                                   [&](const Mark& m) { return isNear(m, x, y, 0.5 * std::sqrt(2.0) * of.edge); });
      along += any ? 1U : 0U;
      of.sums[(row + 1) * (columns + 1) + column + 1] =
          of.sums[row * (columns + 1) + column + 1] + static_cast<int>(along);
    }
  return of;
}

void holdTexels(GLint unit, GLenum kind, const GlTexture& texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(kind, texture.name());
}

}  // namespace

GlField::GlField(const PaintedGround& ground) : ground_(ground) {
  if (ground.texture) throw std::invalid_argument("OpenGL draws no picture on the carpet; leave out `texture`");
  const std::vector<Mark> marks = marksOf(ground);
  double low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  for (const Mark& m : marks) {
    low_x = std::min(low_x, m.x - reachOf(m)), high_x = std::max(high_x, m.x + reachOf(m));
    low_y = std::min(low_y, m.y - reachOf(m)), high_y = std::max(high_y, m.y + reachOf(m));
  }
  low_x -= kFootprint, low_y -= kFootprint;
  const int columns = static_cast<int>(std::ceil((high_x + kFootprint - low_x) / kCell)) + 1;
  const int rows = static_cast<int>(std::ceil((high_y + kFootprint - low_y) / kCell)) + 1;
  grid_ = {static_cast<float>(low_x), static_cast<float>(low_y), static_cast<float>(1 / kCell),
           static_cast<float>(kFootprint)};
  std::vector<Mark> all = marks;
  std::vector<std::uint32_t> cells;
  // Half a cell's diagonal, and of the footprint, which may lie across, half of its own.
  const double reach = (0.5 * kCell + 0.5 * kFootprint) * std::sqrt(2.0) + 1e-3;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto first = static_cast<std::uint32_t>(all.size());
      for (const Mark& m : marks)
        if (isNear(m, low_x + (column + 0.5) * kCell, low_y + (row + 0.5) * kCell, reach)) all.push_back(m);
      cells.push_back(first), cells.push_back(static_cast<std::uint32_t>(all.size()) - first);
    }
  const auto fineCells = [](double size) { return static_cast<int>(std::ceil(size / kFineCell)); };
  marked_ = markedCells(marks, {low_x, low_y, kFineCell, fineCells(columns * kCell), fineCells(rows * kCell), {}});
  if (all.empty()) all.push_back({});  // a buffer must not be empty
  fillBuffer(GL_TEXTURE_BUFFER, values_, all, GL_STATIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, marks_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, values_.name());
  glBindTexture(GL_TEXTURE_2D, cells_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, columns, rows, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, cells.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GlField::set(const GlProgram& program, const Vector3& eye_W) const {
  const double half_carpet = ground_.half_length + ground_.half_width;
  double farthest = norm(eye_W) + half_carpet;
  for (const Mark& m : marksOf(ground_)) farthest = std::max(farthest, norm(eye_W - Vector3{m.x, m.y, 0}) + reachOf(m));
  program.set("w_far", static_cast<float>(1.0 / (1.25 * farthest + 1.0)));
  program.set("grid", grid_);
  program.set("count", static_cast<int>(ground_.lines.size() + ground_.circles.size()));
  program.set("half_carpet",
              std::array<float, 3>{static_cast<float>(ground_.half_length), static_cast<float>(ground_.half_width), 0});
  program.set("marks", 1), program.set("cells", 2);
  holdTexels(1, GL_TEXTURE_BUFFER, marks_);
  holdTexels(2, GL_TEXTURE_2D, cells_);
}

}  // namespace murosimf
