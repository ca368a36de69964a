// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/raw_offset.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// 1 + cos of the turn below which a mitre would reach farther than twice the offset.
constexpr double kSharpest = 0.5;
/// Below this an outline goes back the way it came, but for rounding.
constexpr double kReturning = 1e-12;

/// An edge, from its point to the next one.
struct OffsetEdge {
  Point2 direction;  // unit
  double length;
};

/// The corner between two edges.
struct Corner {
  double sine;  // of the turn; positive to the left
  double one_plus_cosine;

  Corner(const OffsetEdge& in, const OffsetEdge& out)
      : sine(cross(in.direction, out.direction)), one_plus_cosine(1.0 + in.direction.dot(out.direction)) {}

  bool opens(double delta) const { return sine * delta >= 0.0; }
  /// By how much both edges become shorter.
  double trim(double delta) const {
    if (opens(delta)) return 0.0;
    if (one_plus_cosine < kReturning) return std::numeric_limits<double>::infinity();
    return std::abs(delta * sine) / one_plus_cosine;
  }
};

Polygon withoutRepeats(const Polygon& polygon) {
  Polygon result;
  result.reserve(polygon.size());
  for (const Point2& point : polygon)
    if (result.empty() || result.back() != point) result.push_back(point);
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  return result;
}

class RawOffset {
 public:
  RawOffset(const Polygon& polygon, double delta) : polygon_(withoutRepeats(polygon)), delta_(delta) {
    const std::size_t count = polygon_.size();
    edges_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point2 along = polygon_[i + 1 < count ? i + 1 : 0] - polygon_[i];
      const double length = along.norm();
      edges_.push_back({along / length, length});
    }
    trims_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) trims_.push_back(Corner(before(i), edges_[i]).trim(delta));
  }

  bool isOutline() const { return polygon_.size() > 2; }

  Polygon result() && {
    moved_.reserve(polygon_.size() + 16);
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Corner corner(before(i), edges_[i]);
      if (!corner.opens(delta_) && !isTrimmed(i))
        doubleBack(i);
      else if (corner.one_plus_cosine >= kSharpest || !corner.opens(delta_))
        mitre(i, corner);
      else
        cutSquare(i, corner);
    }
    return std::move(moved_);
  }

 private:
  std::size_t previous(std::size_t i) const { return i == 0 ? polygon_.size() - 1 : i - 1; }
  const OffsetEdge& before(std::size_t i) const { return edges_[previous(i)]; }

  /// Whether what both ends take off an edge leaves something of it.
  bool isLongEnough(std::size_t edge) const {
    const std::size_t end = edge + 1 < polygon_.size() ? edge + 1 : 0;
    return trims_[edge] + trims_[end] <= edges_[edge].length;
  }
  bool isTrimmed(std::size_t i) const { return isLongEnough(previous(i)) && isLongEnough(i); }

  void mitre(std::size_t i, const Corner& corner) {
    const Point2 both = rightOf(before(i).direction) + rightOf(edges_[i].direction);
    moved_.push_back(polygon_[i] + delta_ / corner.one_plus_cosine * both);
  }

  void cutSquare(std::size_t i, const Corner& corner) {
    const double reach = std::tan(0.25 * std::atan2(corner.sine, corner.one_plus_cosine - 1.0));
    const Point2& in = before(i).direction;
    const Point2& out = edges_[i].direction;
    moved_.push_back(polygon_[i] + delta_ * (rightOf(in) + reach * in));
    moved_.push_back(polygon_[i] + delta_ * (rightOf(out) - reach * out));
  }

  void doubleBack(std::size_t i) {
    moved_.push_back(polygon_[i] + delta_ * rightOf(before(i).direction));
    moved_.push_back(polygon_[i]);
    moved_.push_back(polygon_[i] + delta_ * rightOf(edges_[i].direction));
  }

  Polygon polygon_;
  double delta_;
  std::vector<OffsetEdge> edges_;
  std::vector<double> trims_;  // at each corner
  Polygon moved_;
};

}  // namespace

Polygon rawOffset(const Polygon& polygon, double delta) {
  RawOffset moved(polygon, delta);
  return moved.isOutline() ? std::move(moved).result() : Polygon();
}

}  // namespace lamina
