// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lattice/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMostCells = 5e7;
/// The lattice keeps this part of the spacing off the box, so that its border rows are inside where the
/// border is a little slanted.
constexpr double kInset = 0.05;

Box2 turnedBox(const Region& region, const RasterFrame& turn) {
  Box2 box;
  for (const Point2& point : region.outer) box.include(turn.intoRaster(point));
  return box;
}

void refuseTooFine(double spacing, const Point2& size) {
  if (!(spacing > 0.0 && std::isfinite(spacing)))
    throw InvalidInput("infill spacing is " + numberText(spacing) + " mm; must be positive");
  if (size.x() / spacing + 2.0 > kMostCells / (size.y() / spacing + 2.0))
    throw InvalidInput("infill spacing is " + numberText(spacing) + " mm; too small for a region " +
                       numberText(size.x()) + " x " + numberText(size.y()) + " mm across");
}

Region mapped(const Region& region, const LatticeFrame& frame) {
  Region result = region;
  for (Point2& point : result.outer) point = frame.intoLattice(point);
  for (Polygon& hole : result.holes)
    for (Point2& point : hole) point = frame.intoLattice(point);
  return result;
}

/// Calls use(line, place) for every cell on a line that the line leads on from to the next cell, without
/// leaving the region; places count 1/sqrt(2) along the line.
template <class Use>
void forCellPairs(const Raster& diagonals, Use use) {
  for (std::size_t i = 0; i + 1 < diagonals.sorted.size(); i += 2) {
    const Crossing& from = diagonals.crossings[diagonals.sorted[i]];
    const double end = diagonals.crossings[diagonals.sorted[i + 1]].x * M_SQRT2;
    auto place = static_cast<std::int64_t>(std::ceil(from.x * M_SQRT2));
    if ((place - from.line) % 2 != 0) ++place;
    for (; static_cast<double>(place + 2) <= end; place += 2) use(from.line, place);
  }
}

}  // namespace

LatticeFrame::LatticeFrame(const Region& region, double spacing_mm, double angle_rad) : turn_(angle_rad) {
  const Box2 box = turnedBox(region, turn_);
  refuseTooFine(spacing_mm, box.size());
  if (box.isEmpty()) return;
  const Point2 size = box.size();
  const auto fit = [spacing_mm](double length) {
    return static_cast<int>(std::lround(std::max(0.0, length / spacing_mm - 2.0 * kInset)));
  };
  columns_ = fit(size.x()) + 1;
  rows_ = fit(size.y()) + 1;
  for (const int axis : {0, 1}) {
    const int steps = (axis == 0 ? columns_ : rows_) - 1;
    const double inset = steps > 0 ? kInset * spacing_mm : 0.5 * size[axis];
    step_[axis] = steps > 0 ? (size[axis] - 2.0 * inset) / steps : spacing_mm;
    corner_[axis] = box.low[axis] + inset;
  }
}

double beadWidth(const LatticeFrame& frame, const InfillRequest& request) {
  return request.pitch_mm * frame.step().prod() / std::pow(request.spacing_mm, 2);
}

Point2 LatticeFrame::intoLattice(const Point2& point) const {
  return (turn_.intoRaster(point) - corner_).cwiseQuotient(step_);
}

Point2 LatticeFrame::outOfLattice(const Point2& point) const {
  return turn_.outOfRaster(corner_ + point.cwiseProduct(step_));
}

Point2 LatticeFrame::centre(const Cell& cell) const { return outOfLattice(Point2(cell.column, cell.row)); }

Lattice::Lattice(const Region& centre_lines, double spacing_mm, double angle_rad)
    : frame(centre_lines, spacing_mm, angle_rad) {
  bits_.assign(static_cast<std::size_t>(frame.columns()) * static_cast<std::size_t>(frame.rows()), 0);
  region_ = {mapped(centre_lines, frame)};
  rows = rasterise(region_, 1.0, RasterFrame(0.0));
  columns = rasterise(region_, 1.0, RasterFrame(M_PI / 2));
  markRows();
  markColumns();
}

void Lattice::markRows() {
  for (std::size_t i = 0; i + 1 < rows.sorted.size(); i += 2) {
    const Crossing& from = rows.crossings[rows.sorted[i]];
    const double end = rows.crossings[rows.sorted[i + 1]].x;
    if (from.line < 0 || from.line >= frame.rows()) continue;
    const int last = std::min(frame.columns() - 1, static_cast<int>(std::floor(end)));
    for (int column = std::max(0, static_cast<int>(std::ceil(from.x))); column <= last; ++column)
      bits_[indexOf({column, static_cast<int>(from.line)})] |= column < last ? kInside | kRight : kInside;
  }
}

void Lattice::markColumns() {
  const auto stride = static_cast<std::size_t>(frame.columns());
  for (std::size_t i = 0; i + 1 < columns.sorted.size(); i += 2) {
    const Crossing& from = columns.crossings[columns.sorted[i]];
    const double end = columns.crossings[columns.sorted[i + 1]].x;
    const int column = static_cast<int>(-from.line);
    if (column < 0 || column >= frame.columns()) continue;
    const int last = std::min(frame.rows() - 1, static_cast<int>(std::floor(end)));
    for (int row = std::max(0, static_cast<int>(std::ceil(from.x))); row < last; ++row) {
      const std::size_t cell = indexOf({column, row});
      if (isInside(cell) && isInside(cell + stride)) bits_[cell] |= kUp;
    }
  }
}

/// In a frame turned by an eighth the lines through the cells lie 1/sqrt(2) apart, and on them the cells lie
/// sqrt(2) apart: at every other multiple of 1/sqrt(2).
void Lattice::findDiagonals() {
  const Raster rising = rasterise(region_, M_SQRT1_2, RasterFrame(0.25 * M_PI));
  forCellPairs(rising, [this](std::int64_t line, std::int64_t place) {
    const Cell from{static_cast<int>((place - line) / 2), static_cast<int>((place + line) / 2)};
    markDiagonal(from, {from.column + 1, from.row + 1}, kUpRight);
  });
  const Raster falling = rasterise(region_, M_SQRT1_2, RasterFrame(-0.25 * M_PI));
  forCellPairs(falling, [this](std::int64_t line, std::int64_t place) {
    const Cell upper{static_cast<int>((line + place) / 2), static_cast<int>((line - place) / 2)};
    markDiagonal({upper.column + 1, upper.row - 1}, upper, kUpLeft);
  });
}

void Lattice::markDiagonal(const Cell& from, const Cell& to, std::uint8_t step) {
  if (!holds(from) || !holds(to)) return;
  if (isInside(indexOf(from)) && isInside(indexOf(to))) bits_[indexOf(from)] |= step;
}

}  // namespace lamina
