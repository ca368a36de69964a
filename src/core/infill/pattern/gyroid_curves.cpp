// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/gyroid_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// Where a curve crosses a side of a grid cell, and the crossings before and after it.
struct SideCrossing {
  Point2 point;
  std::array<std::uint32_t, 2> neighbours{kNobody, kNobody};
};

/// A side of a cell, between two nodes with their values.
struct CellSide {
  Point2 from;
  Point2 to;
  double from_value;
  double to_value;
};

/// Near enough to the surface: less than 1e-4 of what makes up a cell.
constexpr double kNoValue = 1e-4;

/// By regula falsi, the value at the end that stays halved.
Point2 zeroOn(const CellSide& side, const GyroidSection& section) {
  double low = 0.0, high = 1.0, at_low = side.from_value, at_high = side.to_value;
  int last = 0;  // which end moved
  for (int i = 0; i < 12; ++i) {
    const double at = low + (high - low) * at_low / (at_low - at_high);
    Point2 point = side.from + at * (side.to - side.from);
    const double value = section.value(point);
    if (std::abs(value) < kNoValue) return point;
    if ((value >= 0.0) == (at_low >= 0.0)) {
      low = at, at_low = value;
      if (last < 0) at_high *= 0.5;
      last = -1;
    } else {
      high = at, at_high = value;
      if (last > 0) at_low *= 0.5;
      last = 1;
    }
  }
  return side.from + 0.5 * (low + high) * (side.to - side.from);
}

/// Chains of crossings through the cells of a grid, row by row.
class SquareMarch {
 public:
  SquareMarch(const GyroidSection& section, const Box2& box, double step_mm)
      : section_(section),
        low_(box.low - Point2(step_mm, step_mm)),
        step_(step_mm),
        columns_(static_cast<std::size_t>(box.size().x() / step_mm) + 3),
        rows_(static_cast<std::size_t>(box.size().y() / step_mm) + 3) {}

  std::vector<SideCrossing> march() && {
    std::vector<double> below = values(0);
    std::vector<std::uint32_t> sides_below = levelSides(0, below);
    for (std::size_t row = 0; row < rows_; ++row) {
      const std::vector<double> above = values(row + 1);
      std::vector<std::uint32_t> sides_above = levelSides(row + 1, above);
      const std::vector<std::uint32_t> upright = uprightSides(row, below, above);
      for (std::size_t column = 0; column < columns_; ++column)
        joinInCell({sides_below[column], upright[column + 1], sides_above[column], upright[column]},
                   {below[column], below[column + 1], above[column], above[column + 1]});
      below = above;
      sides_below = std::move(sides_above);
    }
    return std::move(crossings_);
  }

 private:
  Point2 node(std::size_t column, std::size_t row) const {
    return low_ + step_ * Point2(static_cast<double>(column), static_cast<double>(row));
  }

  std::vector<double> values(std::size_t row) const {
    return section_.row(node(0, row), step_, columns_ + 1);
  }

  std::uint32_t crossingOn(const CellSide& side) {
    if ((side.from_value >= 0.0) == (side.to_value >= 0.0)) return kNobody;
    crossings_.push_back({zeroOn(side, section_)});
    return static_cast<std::uint32_t>(crossings_.size() - 1);
  }

  std::vector<std::uint32_t> levelSides(std::size_t row, const std::vector<double>& values) {
    std::vector<std::uint32_t> sides;
    sides.reserve(columns_);
    for (std::size_t i = 0; i < columns_; ++i)
      sides.push_back(crossingOn({node(i, row), node(i + 1, row), values[i], values[i + 1]}));
    return sides;
  }

  std::vector<std::uint32_t> uprightSides(std::size_t row, const std::vector<double>& below,
                                          const std::vector<double>& above) {
    std::vector<std::uint32_t> sides;
    sides.reserve(columns_ + 1);
    for (std::size_t i = 0; i <= columns_; ++i)
      sides.push_back(crossingOn({node(i, row), node(i, row + 1), below[i], above[i]}));
    return sides;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      std::array<std::uint32_t, 2>& neighbours = crossings_[from].neighbours;
      neighbours[neighbours[0] == kNobody ? 0 : 1] = to;
    }
  }

  /// @param sides   below, right, above, left
  /// @param corners  values at the lower left, lower right, upper left and upper right
  void joinInCell(const std::array<std::uint32_t, 4>& sides, const std::array<double, 4>& corners) {
    std::array<std::uint32_t, 4> met{};
    std::size_t count = 0;
    for (const std::uint32_t side : sides)
      if (side != kNobody) met[count++] = side;
    if (count == 2) join(met[0], met[1]);
    if (count != 4) return;
    // The sign at the saddle of the bilinear function says which corners hang together.
    const bool is_saddle_positive = (corners[0] * corners[3] - corners[1] * corners[2]) *
                                        (corners[0] + corners[3] - corners[1] - corners[2]) >=
                                    0.0;
    if (is_saddle_positive == (corners[0] >= 0.0)) {
      join(sides[0], sides[1]);
      join(sides[2], sides[3]);
    } else {
      join(sides[0], sides[3]);
      join(sides[1], sides[2]);
    }
  }

  const GyroidSection& section_;
  Point2 low_;
  double step_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<SideCrossing> crossings_;
};

/// Puts points between two on the surface until the chords follow it.
class ChordDivider {
 public:
  ChordDivider(const GyroidSection& section, double chord_error_mm)
      : section_(section), chord_error_(chord_error_mm) {}

  Polyline divided(const Polyline& curve) const {
    Polyline result{curve.front()};
    const auto add = [&result](const Point2& point) {
      if (point != result.back()) result.push_back(point);
    };
    Point2 normal = section_.valueAndSlope(curve.front()).gradient;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Point2 next = section_.valueAndSlope(curve[i]).gradient;
      forEachOnMotion({curve[i - 1], normal}, {curve[i], next}, kDeepest, add);
      normal = next;
    }
    return result;
  }

 private:
  static constexpr int kDeepest = 5;
  struct SurfacePoint {
    Point2 point;
    Point2 normal;  ///< of any length
  };

  /// The points of a motion behind its first one.
  template <class Visit>
  void forEachOnMotion(const SurfacePoint& from, const SurfacePoint& to, int depth,
                       const Visit& visit) const {
    const Point2 chord = to.point - from.point;
    if (depth > 0 && sagOf(chord, from.normal, to.normal) > chord_error_) {
      const SurfacePoint between = onSurface(0.5 * (from.point + to.point), chord);
      forEachOnMotion(from, between, depth - 1, visit);
      forEachOnMotion(between, to, depth - 1, visit);
      return;
    }
    visit(to.point);
  }

  /// Of an arc that leaves the chord by the larger of both angles.
  static double sagOf(const Point2& chord, const Point2& normal_from, const Point2& normal_to) {
    const double length = chord.norm();
    if (length == 0.0) return 0.0;
    const double at_from = std::abs(normal_from.dot(chord)) / (normal_from.norm() + 1e-300);
    const double at_to = std::abs(normal_to.dot(chord)) / (normal_to.norm() + 1e-300);
    return 0.25 * std::max(at_from, at_to);
  }

  /// One step of Newton across the chord, which is nearly exact for chords this short. None farther than a
  /// quarter of it: where curves meet the surface may not be there.
  SurfacePoint onSurface(const Point2& middle, const Point2& chord) const {
    const SectionValue here = section_.valueAndSlope(middle);
    const Point2 across = leftOf(chord);
    const double step = -here.value / here.gradient.dot(across);
    if (!(std::abs(step) <= 0.25)) return {middle, here.gradient};
    return {middle + step * across, here.gradient};
  }

  const GyroidSection& section_;
  double chord_error_;
};

/// Follows the chains of crossings from end to end, then those without ends.
class ChainWalk {
 public:
  explicit ChainWalk(const std::vector<SideCrossing>& crossings)
      : crossings_(crossings), is_done_(crossings.size(), false) {}

  PatternCurves walk() {
    PatternCurves curves;
    for (std::uint32_t i = 0; i < crossings_.size(); ++i)
      if (!is_done_[i] && crossings_[i].neighbours[1] == kNobody) curves.open.push_back(chainFrom(i));
    for (std::uint32_t i = 0; i < crossings_.size(); ++i)
      if (!is_done_[i]) curves.closed.push_back(chainFrom(i));
    return curves;
  }

 private:
  Polyline chainFrom(std::uint32_t i) {
    Polyline points;
    while (i != kNobody) {
      is_done_[i] = true;
      points.push_back(crossings_[i].point);
      std::uint32_t next = kNobody;
      for (const std::uint32_t neighbour : crossings_[i].neighbours)
        if (neighbour != kNobody && !is_done_[neighbour]) next = neighbour;
      i = next;
    }
    return points;
  }

  const std::vector<SideCrossing>& crossings_;
  std::vector<bool> is_done_;
};

}  // namespace

PatternCurves gyroidCurves(const GyroidSection& section, const Box2& box, double step_mm,
                           double chord_error_mm) {
  const std::vector<SideCrossing> crossings = SquareMarch(section, box, step_mm).march();
  PatternCurves curves = ChainWalk(crossings).walk();
  const ChordDivider divider(section, chord_error_mm);
  for (Polyline& curve : curves.open) curve = divider.divided(curve);
  for (Polygon& loop : curves.closed) {
    loop.push_back(loop.front());
    loop = divider.divided(loop);
    loop.pop_back();
  }
  return curves;
}

}  // namespace lamina
