// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/comb_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kInner = 1e-4;  // mm, from the border to where lines along it are checked
constexpr std::size_t kMostCorners = 200;
constexpr double kEdgesPerRow = 4.0;

Point2 nearestOn(const Point2& a, const Point2& b, const Point2& point) {
  const Point2 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return a + share * along;
}

/// Whether a way from a point round a corner touches it, rather than running into the walls beside it.
bool isTangent(const Point2& from, const Point2& corner, const Point2& before, const Point2& after) {
  return side(from, corner, before) * side(from, corner, after) >= 0.0;
}

}  // namespace

/// One search from end to end.
class CombArea::Search {
 public:
  Search(const CombArea& area, const End& from, const End& to, double longest_mm)
      : area_(area),
        corners_(area.corners_[from.region]),
        from_(from.at),
        to_(to.at),
        longest_mm_(longest_mm),
        parents_(corners_.size() + 2, kNone) {}

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
    return isCorner(node) ? corners_[node].at : node == start() ? from_ : to_;
  }
  const Point2& inner(std::size_t node) const { return isCorner(node) ? corners_[node].inner : at(node); }

  bool bendsAt(std::size_t node, const Point2& other) const {
    return !isCorner(node) || isTangent(other, at(node), corners_[node].before, corners_[node].after);
  }

  void expand(std::size_t node, double way_mm) {
    parents_[start()] = start();
    for (std::size_t next = 0; next < parents_.size(); ++next) {
      if (parents_[next] != kNone) continue;
      const double to_next = way_mm + (at(next) - at(node)).norm();
      const double least_mm = to_next + (to_ - at(next)).norm();
      if (least_mm > longest_mm_ || !bendsAt(next, at(node)) || !bendsAt(node, at(next))) continue;
      open_.push({least_mm, to_next, next, node});
    }
  }

  Polyline wayBack() const {
    Polyline way;
    for (std::size_t node = parents_[goal()]; node != start(); node = parents_[node]) way.push_back(at(node));
    std::reverse(way.begin(), way.end());
    return way;
  }

  const CombArea& area_;
  const std::vector<Corner>& corners_;
  Point2 from_;
  Point2 to_;
  double longest_mm_;
  std::vector<std::size_t> parents_;
  std::priority_queue<Step> open_;
};

CombArea::CombArea(const Regions& area) : corners_(area.size()) {
  for (std::size_t i = 0; i < area.size(); ++i) {
    addOutline(area[i].outer, i);
    for (const Polygon& hole : area[i].holes) addOutline(hole, i);
  }
  sortIntoRows();
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

void CombArea::sortIntoRows() {
  if (edges_.empty()) return;
  double high_y = -std::numeric_limits<double>::infinity();
  low_y_ = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_) {
    low_y_ = std::min(low_y_, edge.from.y());
    high_y = std::max(high_y, edge.from.y());
  }
  rows_.resize(1 + static_cast<std::size_t>(static_cast<double>(edges_.size()) / kEdgesPerRow));
  row_mm_ = std::max(high_y - low_y_, 1e-3) / static_cast<double>(rows_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const auto [low, high] = std::minmax(edges_[i].from.y(), edges_[i].to.y());
    for (std::size_t row = rowOf(low); row <= rowOf(high); ++row) rows_[row].push_back(i);
  }
}

std::size_t CombArea::rowOf(double y) const {
  const double row = std::floor((y - low_y_) / row_mm_);
  return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(rows_.size() - 1)));
}

std::optional<std::size_t> CombArea::regionOf(const Point2& point) const {
  bool is_inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t region = 0;
  for (const std::size_t i : rows_[rowOf(point.y())]) {
    const Edge& edge = edges_[i];
    if ((edge.from.y() > point.y()) == (edge.to.y() > point.y())) continue;
    const double x = edge.from.x() + (point.y() - edge.from.y()) / (edge.to.y() - edge.from.y()) *
                                         (edge.to.x() - edge.from.x());
    if (point.x() >= x) continue;
    is_inside = !is_inside;
    if (x >= nearest) continue;
    nearest = x;
    region = edge.region;
  }
  return is_inside ? std::optional(region) : std::nullopt;
}

std::optional<CombArea::End> CombArea::endAt(const Point2& point, double reach_mm) const {
  if (const auto region = regionOf(point)) return End{point, *region};
  double nearest = reach_mm;
  std::optional<Point2> place;
  for (std::size_t row = rowOf(point.y() - reach_mm); row <= rowOf(point.y() + reach_mm); ++row)
    for (const std::size_t i : rows_[row]) {
      const Point2 on_edge = nearestOn(edges_[i].from, edges_[i].to, point);
      const double distance = (on_edge - point).norm();
      if (distance > nearest || distance == 0.0) continue;
      nearest = distance;
      place = on_edge;
    }
  if (!place) return std::nullopt;
  const Point2 inner = *place + kInner / nearest * (*place - point);
  const auto region = regionOf(inner);
  return region ? std::optional(End{inner, *region}) : std::nullopt;
}

bool CombArea::isOpen(const Point2& a, const Point2& b) const {
  const auto [low_x, high_x] = std::minmax(a.x(), b.x());
  const auto [low_y, high_y] = std::minmax(a.y(), b.y());
  for (std::size_t row = rowOf(low_y); row <= rowOf(high_y); ++row)
    for (const std::size_t i : rows_[row]) {
      const Edge& edge = edges_[i];
      if (std::max(edge.from.x(), edge.to.x()) < low_x || std::min(edge.from.x(), edge.to.x()) > high_x)
        continue;
      if (areCrossing(a, b, edge.from, edge.to)) return false;
    }
  return true;
}

std::optional<Polyline> CombArea::shortestWay(const Point2& from, const Point2& to,
                                              const WayLimits& limits) const {
  if (rows_.empty()) return std::nullopt;
  const std::optional<End> start = endAt(from, limits.reach_mm);
  const std::optional<End> end = endAt(to, limits.reach_mm);
  if (!start || !end || start->region != end->region) return std::nullopt;
  const double within_mm = limits.longest_mm - (start->at - from).norm() - (end->at - to).norm();
  if ((end->at - start->at).norm() > within_mm) return std::nullopt;
  std::optional<Polyline> bends = Polyline();
  if (!isOpen(start->at, end->at)) bends = Search(*this, *start, *end, within_mm).bends();
  if (!bends) return std::nullopt;
  Polyline way = {from};
  if (start->at != from) way.push_back(start->at);
  way.insert(way.end(), bends->begin(), bends->end());
  if (end->at != to) way.push_back(end->at);
  way.push_back(to);
  return way;
}

}  // namespace lamina
