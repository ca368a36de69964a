// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/comb_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kInner = 1e-4;        // mm, from the border to where lines along it are checked
constexpr double kUsualDetour = 1.25;  // straight ways
constexpr std::size_t kMostCorners = 1000;

/// Whether a way from a point round a corner touches it, rather than running into the walls beside it.
bool isTangent(const Point2& from, const Point2& corner, const Point2& before, const Point2& after) {
  return side(from, corner, before) * side(from, corner, after) >= 0.0;
}

}  // namespace

/// One search from end to end, among the corners that a way short enough can touch.
class CombArea::Search {
 public:
  Search(const CombArea& area, const End& from, const End& to, double longest_mm)
      : area_(area), from_(from.at), to_(to.at), longest_mm_(longest_mm) {
    const Point2 middle = 0.5 * (from_ + to_);
    const std::vector<CornerByX>& by_x = area.by_x_[from.region];
    const double low_x = middle.x() - 0.5 * longest_mm - kInner;
    const double high_x = middle.x() + 0.5 * longest_mm + kInner;
    for (auto near = std::lower_bound(by_x.begin(), by_x.end(), CornerByX{low_x, 0});
         near != by_x.end() && near->first <= high_x; ++near) {
      const Corner& corner = area.corners_[from.region][near->second];
      if ((corner.at - middle).cwiseAbs().maxCoeff() <= 0.5 * longest_mm &&
          (corner.at - from_).norm() + (corner.at - to_).norm() <= longest_mm)
        corners_.push_back(&corner);
    }
    std::sort(corners_.begin(), corners_.end());  // of ways of equal length the first is taken
    parents_.assign(corners_.size() + 2, kNone);
  }

  /// Without the ends.
  std::optional<Polyline> bends() {
    expand(start(), 0.0);
    std::size_t seen = 0;
    while (!open_.empty()) {
      const Step step = open_.top();
      open_.pop();
      if (parents_[step.node] != kNone) continue;
      if (!area_.isOpen(inner(step.parent), inner(step.node))) continue;
      parents_[step.node] = step.parent;
      if (step.node == goal()) return wayBack();
      if (++seen > kMostCorners) return std::nullopt;
      expand(step.node, step.way_mm);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// A way to a node by another that is reached already, not checked yet.
  struct Step {
    double least_mm;  ///< of the whole way
    double way_mm;    ///< up to the node
    std::size_t node;
    std::size_t parent;

    bool operator<(const Step& other) const {
      return std::tie(other.least_mm, other.node, other.parent) < std::tie(least_mm, node, parent);
    }
  };

  std::size_t start() const { return corners_.size(); }
  std::size_t goal() const { return corners_.size() + 1; }
  bool isCorner(std::size_t node) const { return node < corners_.size(); }
  const Point2& at(std::size_t node) const {
    return isCorner(node) ? corners_[node]->at : node == start() ? from_ : to_;
  }
  const Point2& inner(std::size_t node) const { return isCorner(node) ? corners_[node]->inner : at(node); }

  bool bendsAt(std::size_t node, const Point2& other) const {
    return !isCorner(node) || isTangent(other, at(node), corners_[node]->before, corners_[node]->after);
  }

  void expand(std::size_t node, double way_mm) {
    parents_[start()] = start();
    for (std::size_t next = 0; next < parents_.size(); ++next) {
      if (parents_[next] != kNone || !bendsAt(next, at(node)) || !bendsAt(node, at(next))) continue;
      const double to_next = way_mm + (at(next) - at(node)).norm();
      const double least_mm = to_next + (to_ - at(next)).norm();
      if (least_mm <= longest_mm_) open_.push({least_mm, to_next, next, node});
    }
  }

  Polyline wayBack() const {
    Polyline way;
    for (std::size_t node = parents_[goal()]; node != start(); node = parents_[node]) way.push_back(at(node));
    std::reverse(way.begin(), way.end());
    return way;
  }

  const CombArea& area_;
  std::vector<const Corner*> corners_;
  Point2 from_;
  Point2 to_;
  double longest_mm_;
  std::vector<std::size_t> parents_;
  std::priority_queue<Step> open_;
};

CombArea::CombArea(const Regions& area) : corners_(area.size()), by_x_(area.size()) {
  for (std::size_t i = 0; i < area.size(); ++i) {
    addOutline(area[i].outer, i);
    for (const Polygon& hole : area[i].holes) addOutline(hole, i);
  }
  std::vector<std::pair<Point2, Point2>> ends;
  ends.reserve(edges_.size());
  for (const Edge& edge : edges_) ends.emplace_back(edge.from, edge.to);
  grid_ = EdgeGrid(ends);
  for (std::size_t region = 0; region < corners_.size(); ++region) {
    for (std::size_t i = 0; i < corners_[region].size(); ++i)
      by_x_[region].emplace_back(corners_[region][i].at.x(), i);
    std::sort(by_x_[region].begin(), by_x_[region].end());
  }
}

void CombArea::addOutline(const Polygon& outline, std::size_t region) {
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2& before = outline[(i + count - 1) % count];
    const Point2& at = outline[i];
    const Point2& after = outline[(i + 1) % count];
    edges_.push_back({at, after, region});
    if (side(before, at, after) >= 0.0) continue;
    const Point2 inwards = leftOf((at - before).normalized()) + leftOf((after - at).normalized());
    const double size = inwards.norm();
    if (size < 1e-6) continue;  // a spike, into which nothing can be seen
    // Equally far from both edges.
    corners_[region].push_back({at, before, after, at + 2.0 * kInner / (size * size) * inwards});
  }
}

std::optional<std::size_t> CombArea::regionOf(const Point2& point) const {
  const std::size_t row = grid_.rowOf(point.y());
  const std::size_t first = grid_.columnOf(point.x());
  const std::size_t columns = grid_.columnOf(std::numeric_limits<double>::max()) + 1;
  bool is_inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t region = 0;
  for (std::size_t column = first; column < columns; ++column)
    grid_.forEdgesIn(column, row, [&](std::size_t i) {
      const Edge& edge = edges_[i];
      if ((edge.from.y() > point.y()) == (edge.to.y() > point.y())) return true;
      const double x = edge.from.x() + (point.y() - edge.from.y()) / (edge.to.y() - edge.from.y()) *
                                           (edge.to.x() - edge.from.x());
      // An edge lies in several cells; the crossing in one of them.
      if (point.x() >= x || grid_.columnOf(x) != column) return true;
      is_inside = !is_inside;
      if (x < nearest) {
        nearest = x;
        region = edge.region;
      }
      return true;
    });
  return is_inside ? std::optional(region) : std::nullopt;
}

std::optional<CombArea::End> CombArea::endAt(const Point2& point, double reach_mm) const {
  if (const auto region = regionOf(point)) return End{point, *region};
  double nearest = reach_mm;
  std::optional<Point2> place;
  const auto takeNearer = [&](std::size_t i) {
    const Point2 on_edge = nearestOnSegment(edges_[i].from, edges_[i].to, point);
    const double distance = (on_edge - point).norm();
    if (distance > nearest || distance == 0.0) return true;
    nearest = distance;
    place = on_edge;
    return true;
  };
  for (std::size_t row = grid_.rowOf(point.y() - reach_mm); row <= grid_.rowOf(point.y() + reach_mm); ++row)
    for (std::size_t column = grid_.columnOf(point.x() - reach_mm);
         column <= grid_.columnOf(point.x() + reach_mm); ++column)
      grid_.forEdgesIn(column, row, takeNearer);
  if (!place) return std::nullopt;
  const Point2 inner = *place + kInner / nearest * (*place - point);
  const auto region = regionOf(inner);
  return region ? std::optional(End{inner, *region}) : std::nullopt;
}

bool CombArea::isOpen(const Point2& a, const Point2& b) const {
  return grid_.forCellsAlong(a, b, [&](std::size_t column, std::size_t row) {
    return grid_.forEdgesIn(column, row,
                            [&](std::size_t i) { return !areCrossing(a, b, edges_[i].from, edges_[i].to); });
  });
}

std::optional<Polyline> CombArea::bendsBetween(const End& from, const End& to, double longest_mm) const {
  if (isOpen(from.at, to.at)) return Polyline();
  // Most ways are hardly longer than straight ones, and few corners lie near those.
  const double usual_mm = kUsualDetour * (to.at - from.at).norm();
  if (usual_mm < longest_mm)
    if (std::optional<Polyline> bends = Search(*this, from, to, usual_mm).bends()) return bends;
  return Search(*this, from, to, longest_mm).bends();
}

std::optional<Polyline> CombArea::shortestWay(const Point2& from, const Point2& to,
                                              const WayLimits& limits) const {
  if (grid_.isEmpty()) return std::nullopt;
  const std::optional<End> start = endAt(from, limits.reach_mm);
  const std::optional<End> end = endAt(to, limits.reach_mm);
  if (!start || !end || start->region != end->region) return std::nullopt;
  const double within_mm = limits.longest_mm - (start->at - from).norm() - (end->at - to).norm();
  if ((end->at - start->at).norm() > within_mm) return std::nullopt;
  const std::optional<Polyline> bends = bendsBetween(*start, *end, within_mm);
  if (!bends) return std::nullopt;
  Polyline way = {from};
  if (start->at != from) way.push_back(start->at);
  way.insert(way.end(), bends->begin(), bends->end());
  if (end->at != to) way.push_back(end->at);
  way.push_back(to);
  return way;
}

}  // namespace lamina
