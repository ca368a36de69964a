// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/border_connection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/spatial/edge_grid.hpp"

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

  std::pair<Point2, Point2> edge(std::size_t i) const { return {points_[i], pointAfter(i)}; }

  /// The point of an edge nearest to `point`, and its distance.
  std::pair<BorderPlace, double> nearestOn(std::size_t i, const Point2& point) const {
    const Point2 edge = pointAfter(i) - points_[i];
    const double square = edge.squaredNorm();
    const double t = square > 0.0 ? std::clamp((point - points_[i]).dot(edge) / square, 0.0, 1.0) : 0.0;
    const Point2 foot = points_[i] + t * edge;
    return {{0, i, along_[i] + t * std::sqrt(square), foot}, (foot - point).norm()};
  }

  /// The outline's points on the way onward from one place to the other, both places included.
  Polyline onward(const BorderPlace& from, const BorderPlace& to) const {
    Polyline way = {from.point};
    const bool wraps = to.along_mm < from.along_mm;
    // Both places at the corner between two edges, found on the later one first: there is no way to go.
    const bool is_at_corner = !wraps && to.edge < from.edge;
    const std::size_t count = is_at_corner ? 0 : to.edge + (wraps ? points_.size() : 0) - from.edge;
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

/// A way along the border to an end of another run.
struct Way {
  std::size_t run = 0;
  bool is_reversed = false;  ///< it ends at the last point of that run
  double length_mm = std::numeric_limits<double>::infinity();
  Polyline points;
};

/// Where the first and last point of a run lie on the border, if they do.
using RunPlaces = std::array<std::optional<BorderPlace>, 2>;

bool canBeJoined(const FillPath& run) { return !run.is_closed && !run.width_mm.empty(); }

class BorderWays {
 public:
  BorderWays(const std::vector<FillPath>& runs, const Regions& border, double reach) {
    for (Polygon& outline : outlines(border))
      if (!outline.empty()) outlines_.emplace_back(std::move(outline));
    addEdges();
    places_.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (canBeJoined(runs[i]))
        places_[i] = {placeNear(runs[i].points.front(), reach), placeNear(runs[i].points.back(), reach)};
  }

  /// The shortest way from an end of a run, 0 for its first and 1 for its last point, to one of `others`.
  std::optional<Way> shortest(std::size_t run, std::size_t end,
                              const std::vector<std::size_t>& others) const {
    const std::optional<BorderPlace>& from = places_[run][end];
    if (!from) return std::nullopt;
    Way way;
    for (const std::size_t other : others)
      for (const std::size_t entry : {0, 1}) {
        const std::optional<BorderPlace>& to = places_[other][entry];
        if (!to || to->outline != from->outline) continue;
        const double length = lengthBetween(*from, *to);
        if (length < way.length_mm) way = {other, entry == 1, length, {}};
      }
    if (!std::isfinite(way.length_mm)) return std::nullopt;
    way.points = pointsBetween(*from, *places_[way.run][way.is_reversed ? 1 : 0]);
    return way;
  }

 private:
  double onward(const BorderPlace& from, const BorderPlace& to) const {
    const double along = to.along_mm - from.along_mm;
    return along < 0.0 ? along + outlines_[from.outline].length() : along;
  }

  double lengthBetween(const BorderPlace& from, const BorderPlace& to) const {
    const double along = onward(from, to);
    return std::min(along, outlines_[from.outline].length() - along);
  }

  Polyline pointsBetween(const BorderPlace& from, const BorderPlace& to) const {
    const MeasuredOutline& outline = outlines_[from.outline];
    const double along = onward(from, to);
    if (along <= outline.length() - along) return outline.onward(from, to);
    Polyline way = outline.onward(to, from);
    std::reverse(way.begin(), way.end());
    return way;
  }

  struct BorderEdge {
    std::size_t outline = 0;
    std::size_t edge = 0;
  };

  void addEdges() {
    std::vector<std::pair<Point2, Point2>> ends;
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      for (std::size_t k = 0; k < outlines_[i].size(); ++k) {
        edges_.push_back({i, k});
        ends.push_back(outlines_[i].edge(k));
      }
    grid_ = EdgeGrid(ends);
  }

  /// The edges that may lie within reach, in their order round each outline.
  std::vector<std::size_t> edgesNear(const Point2& point, double reach) const {
    const Point2 around = Point2::Constant(reach + kRounding);
    std::vector<std::size_t> near;
    grid_.forEdgesNear({point - around, point + around}, [&](std::size_t edge) { near.push_back(edge); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  /// Of edges of one outline that are equally near, the first; of outlines, the last.
  std::optional<BorderPlace> placeNear(const Point2& point, double reach) const {
    std::optional<BorderPlace> found;
    double least = reach;
    for (const std::size_t near : edgesNear(point, reach)) {
      const BorderEdge& each = edges_[near];
      auto [place, distance] = outlines_[each.outline].nearestOn(each.edge, point);
      const bool is_same_outline = found && found->outline == each.outline;
      if (distance > least || (is_same_outline && distance == least)) continue;
      least = distance;
      place.outline = each.outline;
      found = place;
    }
    return found;
  }

  static constexpr double kRounding = 1e-6;  // mm

  std::vector<MeasuredOutline> outlines_;
  std::vector<BorderEdge> edges_;
  EdgeGrid grid_;
  std::vector<RunPlaces> places_;
};

void append(FillPath& run, const Point2& point, double width) {
  if ((run.points.back() - point).norm() < 1e-6) return;
  run.points.push_back(point);
  run.width_mm.push_back(width);
}

/// Of a connection by that way, with the steps from the end of the run to the border and from there to the
/// next run [mm].
double lengthOf(const Way& way, const FillPath& run, const FillPath& next) {
  const Point2& entry = way.is_reversed ? next.points.back() : next.points.front();
  return (way.points.front() - run.points.back()).norm() + way.length_mm + (entry - way.points.back()).norm();
}

void join(FillPath& run, const Polyline& way, double width, const FillPath& next) {
  for (const Point2& point : way) append(run, point, width);
  append(run, next.points.front(), width);
  run.points.insert(run.points.end(), next.points.begin() + 1, next.points.end());
  run.width_mm.insert(run.width_mm.end(), next.width_mm.begin() + 1, next.width_mm.end());
}

}  // namespace

std::vector<FillPath> connectAlongBorder(std::vector<FillPath> runs, const Regions& border,
                                         const BorderConnection& connection) {
  if (runs.size() < 2 || connection.longest_mm <= 0.0) return runs;
  const BorderWays ways(runs, border, connection.reach_mm);
  std::vector<std::size_t> open(runs.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<FillPath> connected;
  double left_mm2 = connection.most_mm2;
  while (!open.empty()) {
    std::size_t at = open.front();
    std::size_t end = 1;
    open.erase(open.begin());
    connected.push_back(std::move(runs[at]));
    while (const std::optional<Way> way = ways.shortest(at, end, open)) {
      const double area = lengthOf(*way, connected.back(), runs[way->run]) * connection.width_mm;
      if (way->length_mm > connection.longest_mm || area > left_mm2) break;
      left_mm2 -= area;
      at = way->run;
      end = way->is_reversed ? 0 : 1;
      open.erase(std::find(open.begin(), open.end(), at));
      join(connected.back(), way->points, connection.width_mm,
           way->is_reversed ? reversed(std::move(runs[at])) : std::move(runs[at]));
    }
  }
  return connected;
}

}  // namespace lamina
