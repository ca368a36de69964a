// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/sharp_tips.hpp"

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Cosine of the turn at a corner of 60 degrees.
constexpr double kSharpest = -0.5;
/// The border may stand so far beside the edges of the grown core, in reaches.
constexpr double kBeside = 0.1;

struct Corner {
  Point2 point;
  Point2 in;   // as long as the edge
  Point2 out;  // as long as the edge

  Corner(const Polygon& outline, std::size_t i)
      : point(outline[i]),
        in(outline[i] - outline[i > 0 ? i - 1 : outline.size() - 1]),
        out(outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i]) {}

  bool isSharp() const { return cross(in, out) > 0.0 && in.dot(out) < kSharpest * in.norm() * out.norm(); }
};

/// The line that cuts a corner square, seen from the corner: how far a point is beyond it, and how far beside
/// the middle of the cut.
class SquareCut {
 public:
  SquareCut(const Corner& corner, double reach) : corner_(corner.point), reach_(reach) {
    const Point2 in = corner.in.normalized();
    const Point2 out = corner.out.normalized();
    outwards_ = (rightOf(in) + rightOf(out)).normalized();
    half_ = reach * std::tan(0.25 * turn(in, out)) + kBeside * reach;
  }

  double beyond(const Point2& point) const { return (point - corner_).dot(outwards_) - reach_; }
  bool isOnCut(const Point2& point) const { return std::abs(cross(outwards_, point - corner_)) <= half_; }

 private:
  Point2 corner_;
  Point2 outwards_;
  double reach_;
  double half_;  // of the length of the cut
};

/// Where the border crosses a cut, on the edge from this point on.
struct Crossing {
  std::size_t outline = 0;
  std::size_t edge = 0;
  double t = 0.0;  ///< 0 to 1 along the edge
  Point2 point = Point2::Zero();
};

struct Passage {
  std::vector<Crossing> out;   ///< beyond the cut
  std::vector<Crossing> back;  ///< behind it again
};

Passage passageOf(const std::vector<Polygon>& border, const SquareCut& cut) {
  Passage passage;
  for (std::size_t k = 0; k < border.size(); ++k) {
    const Polygon& points = border[k];
    double beyond = cut.beyond(points.back());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t edge = i > 0 ? i - 1 : points.size() - 1;
      const double before = std::exchange(beyond, cut.beyond(points[i]));
      if ((before > 0.0) == (beyond > 0.0)) continue;
      const double t = before / (before - beyond);
      const Point2 at = points[edge] + t * (points[i] - points[edge]);
      if (cut.isOnCut(at)) (beyond > 0.0 ? passage.out : passage.back).push_back({k, edge, t, at});
    }
  }
  return passage;
}

/// The border with what was cut off it so far.
class CutBorder {
 public:
  explicit CutBorder(std::vector<Polygon> border) : border_(std::move(border)) {
    for (const Polygon& outline : border_) marks_.emplace_back(outline.size());
  }

  const std::vector<Polygon>& whole() const { return border_; }

  /// What is cut off from one crossing to the other; nothing if some of it is off already, or lies outside.
  std::optional<Polygon> cutOff(const Crossing& from, const Crossing& to) {
    const Polygon& points = border_[from.outline];
    std::vector<Mark>& marks = marks_[from.outline];
    if (marks[from.edge].leaves || marks[to.edge].returns) return std::nullopt;
    marks[from.edge].leaves = from;
    marks[to.edge].returns = to;
    Polygon tip = {from.point};
    for (std::size_t i = from.edge; i != to.edge;) {
      i = i + 1 < points.size() ? i + 1 : 0;
      if (std::exchange(marks[i].is_off, true)) return std::nullopt;
      tip.push_back(points[i]);
    }
    tip.push_back(to.point);
    if (!(signedArea(tip) > 0.0)) return std::nullopt;
    return tip;
  }

  /// Nothing if two cuts overlap.
  std::optional<std::vector<Polygon>> rest() const {
    std::vector<Polygon> rest;
    for (std::size_t k = 0; k < border_.size(); ++k) {
      Polygon outline;
      for (std::size_t i = 0; i < border_[k].size(); ++i) {
        const Mark& mark = marks_[k][i];
        if (!mark.is_off) outline.push_back(border_[k][i]);
        if (mark.returns && mark.leaves && mark.returns->t >= mark.leaves->t) return std::nullopt;
        if (mark.returns) outline.push_back(mark.returns->point);
        if (mark.leaves) outline.push_back(mark.leaves->point);
      }
      if (outline.size() < 3) return std::nullopt;
      rest.push_back(std::move(outline));
    }
    return rest;
  }

 private:
  /// Of a point and the edge from it on.
  struct Mark {
    bool is_off = false;
    std::optional<Crossing> returns;
    std::optional<Crossing> leaves;
  };

  std::vector<Polygon> border_;
  std::vector<std::vector<Mark>> marks_;
};

}  // namespace

bool hasSharpCorner(const Region& region) {
  for (const Polygon& outline : outlines({region}))
    for (std::size_t i = 0; i < outline.size(); ++i)
      if (Corner(outline, i).isSharp()) return true;
  return false;
}

std::optional<TipCut> cutSharpTips(const Region& area, const Region& core, double reach_mm) {
  CutBorder border(outlines({area}));
  Regions tips;
  for (const Polygon& outline : outlines({core})) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Corner corner(outline, i);
      if (!corner.isSharp()) continue;
      const Passage passage = passageOf(border.whole(), SquareCut(corner, reach_mm));
      if (passage.out.empty() && passage.back.empty()) continue;
      if (passage.out.size() != 1 || passage.back.size() != 1) return std::nullopt;
      const Crossing& from = passage.out.front();
      const Crossing& to = passage.back.front();
      if (from.outline != to.outline) return std::nullopt;
      std::optional<Polygon> tip = border.cutOff(from, to);
      if (!tip) return std::nullopt;
      tips.push_back({std::move(*tip), {}});
    }
  }
  std::optional<std::vector<Polygon>> rest = border.rest();
  if (!rest) return std::nullopt;
  Region left{std::move(rest->front()), {}};
  left.holes.assign(std::make_move_iterator(rest->begin() + 1), std::make_move_iterator(rest->end()));
  return TipCut{std::move(left), std::move(tips)};
}

}  // namespace lamina
