// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/crossed_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/polygon/nesting.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kGrid = 1e-5;     // mm: points nearer to each other are one
constexpr double kClear = 2.5e-5;  // mm: areas may overlap themselves by rounding to the grid

void append(Polygon& outline, const Point2& point) {
  if (outline.empty() || (point - outline.back()).cwiseAbs().maxCoeff() > kGrid) outline.push_back(point);
}

bool overlap(const Box2& a, const Box2& b) {
  return (a.low.array() <= b.high.array() + kClear).all() && (b.low.array() <= a.high.array() + kClear).all();
}

/// Without points that lie on each other; empty if nothing of any width is left.
Polygon tidied(Polygon outline) {
  while (outline.size() > 1 && (outline.back() - outline.front()).cwiseAbs().maxCoeff() <= kGrid)
    outline.pop_back();
  if (outline.size() < 3 || std::abs(signedArea(outline)) < kGrid * perimeter(outline)) outline.clear();
  return outline;
}

/// How often the outline winds round the point, counter-clockwise.
int windingRound(const Polygon& outline, const Point2& point) {
  int winding = 0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point2& a = outline[j];
    const Point2& b = outline[i];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      winding += b.y() > a.y() ? 1 : -1;
  }
  return winding;
}

}  // namespace

bool CrossedOutlines::Area::encloses(const Point2& point) const {
  int winding = 0;
  for (const Outline& outline : outlines) {
    const bool is_near =
        (outline.box.low.array() <= point.array()).all() && (point.array() <= outline.box.high.array()).all();
    if (is_near) winding += windingRound(*outline.points, point);
  }
  return winding != 0;
}

CrossedOutlines::Area CrossedOutlines::areaOf(const Regions& regions) {
  Area area;
  std::uint32_t count = 0;
  const auto add = [&](const Polygon& points, bool is_hole) {
    if (points.size() < 3) return;
    const auto number = static_cast<std::uint32_t>(area.outlines.size());
    Outline outline;
    outline.points = &points;
    outline.region = count;
    outline.is_hole = is_hole;
    outline.first = static_cast<std::uint32_t>(area.edges.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      outline.box.include(points[i]);
      area.edges.push_back({&points, number, i});
    }
    area.box.include(outline.box.low);
    area.box.include(outline.box.high);
    area.outlines.push_back(outline);
  };
  for (const Region& region : regions) {
    add(region.outer, false);
    for (const Polygon& hole : region.holes) add(hole, true);
    ++count;
  }
  return area;
}

CrossedOutlines::CrossedOutlines(const Regions& a, const Regions& b)
    : areas_{areaOf(a), areaOf(b)}, is_clear_(findCrossings()) {
  for (std::size_t side = 0; side < 2; ++side) is_clear_ = is_clear_ && linkCrossings(side);
  for (const Area& area : areas_) is_clear_ = is_clear_ && !mayOverlapItself(area);
}

/// Or touch: what runs along each other may well overlap.
bool CrossedOutlines::mayMeet(const Outline& a, const Outline& b) {
  const Point2 low = a.box.low.cwiseMax(b.box.low).array() - kClear;
  const Point2 high = a.box.high.cwiseMin(b.box.high).array() + kClear;
  std::array<std::vector<std::pair<Point2, Point2>>, 2> edges;
  for (std::size_t side = 0; side < 2; ++side) {
    const Polygon& points = side == 0 ? *a.points : *b.points;
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
      if ((points[i].cwiseMax(points[j]).array() >= low.array()).all() &&
          (points[i].cwiseMin(points[j]).array() <= high.array()).all())
        edges[side].emplace_back(points[j], points[i]);
  }
  const auto reaches = [](const std::pair<Point2, Point2>& line, const std::pair<Point2, Point2>& edge) {
    const Point2 way = line.second - line.first;
    const double near = kClear * way.norm();
    const double first = cross(way, edge.first - line.first);
    const double second = cross(way, edge.second - line.first);
    return std::min(first, second) <= near && std::max(first, second) >= -near;
  };
  return std::any_of(edges[0].begin(), edges[0].end(), [&](const auto& of_a) {
    return std::any_of(edges[1].begin(), edges[1].end(),
                       [&](const auto& of_b) { return reaches(of_a, of_b) && reaches(of_b, of_a); });
  });
}

/// Whether regions of it may cross each other; what lies within another is found by how often it is wound
/// round.
bool CrossedOutlines::mayOverlapItself(const Area& area) {
  if (area.outlines.empty() || area.outlines.back().region == area.outlines.front().region) return false;
  std::vector<const Outline*> by_x;
  by_x.reserve(area.outlines.size());
  for (const Outline& outline : area.outlines) by_x.push_back(&outline);
  std::sort(by_x.begin(), by_x.end(), [](const Outline* a, const Outline* b) {
    return std::make_pair(a->box.low.x(), a->first) < std::make_pair(b->box.low.x(), b->first);
  });
  for (std::size_t i = 0; i < by_x.size(); ++i)
    for (std::size_t j = i + 1; j < by_x.size() && by_x[j]->box.low.x() <= by_x[i]->box.high.x(); ++j) {
      const Outline& a = *by_x[i];
      const Outline& b = *by_x[j];
      const bool may_overlap = a.region != b.region && !(a.is_hole && b.is_hole) &&
                               a.box.low.y() <= b.box.high.y() && b.box.low.y() <= a.box.high.y();
      if (may_overlap && mayMeet(a, b)) return true;
    }
  return false;
}

/// Only those that lie where both areas do can cross; by their lower ends.
std::vector<CrossedOutlines::SweptEdge> CrossedOutlines::sweptEdges() const {
  std::vector<SweptEdge> swept;
  swept.reserve(areas_[0].edges.size() + areas_[1].edges.size());
  for (std::uint32_t side = 0; side < 2; ++side) {
    const Box2& other = areas_[1 - side].box;
    const Point2 low = other.low.array() - kClear;
    const Point2 high = other.high.array() + kClear;
    for (std::uint32_t i = 0; i < areas_[side].edges.size(); ++i) {
      const Edge& edge = areas_[side].edges[i];
      const auto [low_x, high_x] = std::minmax(edge.begin().x(), edge.end().x());
      const auto [low_y, high_y] = std::minmax(edge.begin().y(), edge.end().y());
      if (high_x >= low.x() && low_x <= high.x() && high_y >= low.y() && low_y <= high.y())
        swept.push_back({low_y, high_y, low_x, high_x, i, side});
    }
  }
  std::vector<std::pair<double, std::uint32_t>> order;
  order.reserve(swept.size());
  for (std::uint32_t i = 0; i < swept.size(); ++i) order.emplace_back(swept[i].low_y, i);
  std::sort(order.begin(), order.end());
  std::vector<SweptEdge> ordered;
  ordered.reserve(swept.size());
  for (const auto& each : order) ordered.push_back(swept[each.second]);
  return ordered;
}

bool CrossedOutlines::findCrossings() {
  if (areas_[0].edges.empty() || areas_[1].edges.empty() || !overlap(areas_[0].box, areas_[1].box))
    return true;
  std::array<std::vector<SweptEdge>, 2> active;
  for (const SweptEdge& edge : sweptEdges()) {
    std::vector<SweptEdge>& others = active[1 - edge.side];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (others[i].high_y + kClear < edge.low_y) continue;
      if (kept != i) others[kept] = others[i];
      const SweptEdge& other = others[kept++];
      if (!(edge.side == 0 ? meet(edge, other) : meet(other, edge))) return false;
    }
    others.resize(kept);
    active[edge.side].push_back(edge);
  }
  return true;
}

/// False where it is not plain whether they cross.
bool CrossedOutlines::meet(const SweptEdge& a, const SweptEdge& b) {
  if (a.high_x + kClear < b.low_x || b.high_x + kClear < a.low_x) return true;
  const Edge& of_a = areas_[0].edges[a.edge];
  const Edge& of_b = areas_[1].edges[b.edge];
  const Point2 way_a = of_a.end() - of_a.begin();
  const Point2 way_b = of_b.end() - of_b.begin();
  const double a_begin = cross(way_b, of_a.begin() - of_b.begin());
  const double a_end = cross(way_b, of_a.end() - of_b.begin());
  const double near_b = kClear * way_b.norm();
  if (std::min(a_begin, a_end) > near_b || std::max(a_begin, a_end) < -near_b) return true;
  const double b_begin = cross(way_a, of_b.begin() - of_a.begin());
  const double b_end = cross(way_a, of_b.end() - of_a.begin());
  const double near_a = kClear * way_a.norm();
  if (std::min(b_begin, b_end) > near_a || std::max(b_begin, b_end) < -near_a) return true;
  if (std::min(std::abs(a_begin), std::abs(a_end)) <= near_b ||
      std::min(std::abs(b_begin), std::abs(b_end)) <= near_a)
    return false;
  const double along_a = a_begin / (a_begin - a_end);
  const Point2 at = of_a.begin() + along_a * way_a;
  crossings_.push_back({{a.edge, b.edge}, {along_a, b_begin / (b_begin - b_end)}, at, a_end > 0.0});
  areas_[0].outlines[of_a.outline].is_crossed = true;
  areas_[1].outlines[of_b.outline].is_crossed = true;
  return true;
}

/// Round each outline. False unless it enters and leaves the other area by turns.
bool CrossedOutlines::linkCrossings(std::size_t side) {
  Area& area = areas_[side];
  std::vector<std::uint32_t> order(crossings_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
    const Crossing& one = crossings_[x];
    const Crossing& other = crossings_[y];
    return std::tie(one.edge[side], one.along[side], x) < std::tie(other.edge[side], other.along[side], y);
  });
  area.next.resize(order.size());
  area.previous.resize(order.size());
  const auto outlineOf = [&](std::uint32_t crossing) {
    return area.edges[crossings_[crossing].edge[side]].outline;
  };
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && outlineOf(order[end]) == outlineOf(order[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t after = order[i + 1 < end ? i + 1 : begin];
      area.next[order[i]] = after;
      area.previous[after] = order[i];
    }
    begin = end;
  }
  for (std::uint32_t i = 0; i < order.size(); ++i)
    if (crossings_[area.next[i]].enters == crossings_[i].enters) return false;
  return true;
}

/// The corners between two crossings that follow each other round an outline.
void CrossedOutlines::walk(std::size_t side, std::uint32_t from, std::uint32_t to, Polygon& outline) const {
  const Crossing& start = crossings_[from];
  const Crossing& end = crossings_[to];
  if (start.edge[side] == end.edge[side] && start.along[side] < end.along[side]) return;
  const Edge& first = areas_[side].edges[start.edge[side]];
  const Polygon& points = *first.points;
  const std::uint32_t last = areas_[side].edges[end.edge[side]].from;
  std::size_t at = first.from;
  do {
    at = at + 1 < points.size() ? at + 1 : 0;
    append(outline, points[at]);
  } while (at != last);
}

void CrossedOutlines::walkBack(std::size_t side, std::uint32_t from, std::uint32_t to,
                               Polygon& outline) const {
  const Crossing& start = crossings_[from];
  const Crossing& end = crossings_[to];
  if (start.edge[side] == end.edge[side] && end.along[side] < start.along[side]) return;
  const Edge& first = areas_[side].edges[start.edge[side]];
  const Polygon& points = *first.points;
  const std::uint32_t last = areas_[side].edges[end.edge[side]].from;
  for (std::size_t at = first.from;; at = at > 0 ? at - 1 : points.size() - 1) {
    if (at == last) return;
    append(outline, points[at]);
  }
}

/// Along a within b, or outside of it, then along b within a, there and back again, until round.
std::optional<std::vector<Polygon>> CrossedOutlines::spliced(bool takes_common) const {
  std::vector<Polygon> found;
  std::vector<bool> is_used(crossings_.size(), false);
  for (std::uint32_t first = 0; first < crossings_.size(); ++first) {
    if (is_used[first] || crossings_[first].enters != takes_common) continue;
    Polygon outline;
    std::uint32_t at = first;
    do {
      if (is_used[at]) return std::nullopt;
      is_used[at] = true;
      append(outline, crossings_[at].at);
      const std::uint32_t turn = areas_[0].next[at];
      walk(0, at, turn, outline);
      append(outline, crossings_[turn].at);
      at = takes_common ? areas_[1].next[turn] : areas_[1].previous[turn];
      takes_common ? walk(1, turn, at, outline) : walkBack(1, turn, at, outline);
    } while (at != first);
    outline = tidied(std::move(outline));
    if (!outline.empty()) found.push_back(std::move(outline));
  }
  return found;
}

std::optional<Regions> CrossedOutlines::combined(bool takes_common) const {
  if (!is_clear_) return std::nullopt;
  std::optional<std::vector<Polygon>> found = spliced(takes_common);
  if (!found) return std::nullopt;
  for (std::size_t side = 0; side < 2; ++side)
    for (const Outline& outline : areas_[side].outlines) {
      if (outline.is_crossed) continue;
      const bool is_kept_inside = takes_common || side == 1;
      if (areas_[1 - side].encloses(outline.points->front()) != is_kept_inside) continue;
      found->push_back(*outline.points);
      if (!takes_common && side == 1) std::reverse(found->back().begin(), found->back().end());
    }
  return nest(std::move(*found));
}

std::optional<Regions> CrossedOutlines::common() const { return combined(true); }

std::optional<Regions> CrossedOutlines::rest() const { return combined(false); }

}  // namespace lamina
