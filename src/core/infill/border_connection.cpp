// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/border_connection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace lamina {
namespace {

/// A point of an outline, and how far along it lies.
struct BorderPlace {
  std::size_t outline = 0;
  std::size_t edge = 0;
  double along_mm = 0.0;  ///< from the outline's first point
  Point2 point = Point2::Zero();
};

/// An outline and the length up to each of its points.
class MeasuredOutline {
 public:
  explicit MeasuredOutline(Polygon points) : points_(std::move(points)), along_(points_.size() + 1, 0.0) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      along_[i + 1] = along_[i] + (pointAfter(i) - points_[i]).norm();
  }

  double length() const { return along_.back(); }
  std::size_t size() const { return points_.size(); }
  const Point2& point(std::size_t i) const { return points_[i]; }

  /// The point nearest to `point`, and its distance.
  std::pair<BorderPlace, double> nearest(const Point2& point) const {
    BorderPlace place;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Point2 edge = pointAfter(i) - points_[i];
      const double square = edge.squaredNorm();
      const double t = square > 0.0 ? std::clamp((point - points_[i]).dot(edge) / square, 0.0, 1.0) : 0.0;
      const Point2 foot = points_[i] + t * edge;
      const double distance = (foot - point).norm();
      if (distance >= least) continue;
      least = distance;
      place = {0, i, along_[i] + t * std::sqrt(square), foot};
    }
    return {place, least};
  }

  /// The outline's points on the way onward from one place to the other, both places included.
  Polyline onward(const BorderPlace& from, const BorderPlace& to) const {
    Polyline way = {from.point};
    const bool wraps = to.along_mm < from.along_mm;
    const std::size_t count = to.edge + (wraps || to.edge < from.edge ? points_.size() : 0) - from.edge;
    for (std::size_t step = 1; step <= count; ++step)
      way.push_back(points_[(from.edge + step) % points_.size()]);
    way.push_back(to.point);
    return way;
  }

 private:
  const Point2& pointAfter(std::size_t i) const { return points_[i + 1 < points_.size() ? i + 1 : 0]; }

  Polygon points_;
  std::vector<double> along_;
};

class Connector {
 public:
  Connector(const Regions& border, const BorderConnection& connection) : connection_(connection) {
    for (Polygon& outline : outlines(border))
      if (!outline.empty()) outlines_.emplace_back(std::move(outline));
  }

  /// The way along the border from one point to the other, if there is one.
  std::optional<Polyline> way(const Point2& from, const Point2& to) const {
    const std::optional<BorderPlace> start = placeNear(from);
    const std::optional<BorderPlace> end = placeNear(to);
    if (!start || !end || start->outline != end->outline) return std::nullopt;
    const MeasuredOutline& outline = outlines_[start->outline];
    double onward = end->along_mm - start->along_mm;
    if (onward < 0.0) onward += outline.length();
    const double back = outline.length() - onward;
    if (std::min(onward, back) > connection_.longest_mm) return std::nullopt;
    if (onward <= back) return outline.onward(*start, *end);
    Polyline way = outline.onward(*end, *start);
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  std::optional<BorderPlace> placeNear(const Point2& point) const {
    std::optional<BorderPlace> found;
    double least = connection_.reach_mm;
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      auto [place, distance] = outlines_[i].nearest(point);
      if (distance > least) continue;
      least = distance;
      place.outline = i;
      found = place;
    }
    return found;
  }

  const BorderConnection& connection_;
  std::vector<MeasuredOutline> outlines_;
};

void append(FillPath& run, const Point2& point, double width) {
  if ((run.points.back() - point).norm() < 1e-6) return;
  run.points.push_back(point);
  run.width_mm.push_back(width);
}

void join(FillPath& run, const Polyline& way, double width, const FillPath& next) {
  for (const Point2& point : way) append(run, point, width);
  append(run, next.points.front(), width);
  run.points.insert(run.points.end(), next.points.begin() + 1, next.points.end());
  run.width_mm.insert(run.width_mm.end(), next.width_mm.begin() + 1, next.width_mm.end());
}

bool canBeJoined(const FillPath& a, const FillPath& b) {
  return !a.is_closed && !b.is_closed && a.role == b.role && !a.width_mm.empty() && !b.width_mm.empty();
}

}  // namespace

std::vector<FillPath> connectAlongBorder(std::vector<FillPath> runs, const Regions& border,
                                         const BorderConnection& connection) {
  if (runs.size() < 2 || connection.longest_mm <= 0.0) return runs;
  const Connector connector(border, connection);
  std::vector<FillPath> connected;
  for (FillPath& run : runs) {
    const bool may_join = !connected.empty() && canBeJoined(connected.back(), run);
    const std::optional<Polyline> way =
        may_join ? connector.way(connected.back().points.back(), run.points.front()) : std::nullopt;
    if (way)
      join(connected.back(), *way, connection.width_mm, run);
    else
      connected.push_back(std::move(run));
  }
  return connected;
}

}  // namespace lamina
