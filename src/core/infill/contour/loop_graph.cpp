// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// A link may touch loops at its ends: what lies within this part of its length there is left aside.
constexpr double kTouching = 1e-3;

struct EdgePlace {
  double squared = std::numeric_limits<double>::infinity();
  double part = 0.0;  ///< of the edge
};

EdgePlace nearestOnEdge(const Point2& from, const Point2& to, const Point2& point) {
  const Point2 along = to - from;
  const double part = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return {(from + part * along - point).squaredNorm(), part};
}

/// Points nearer to each other than this are one [mm].
constexpr double kSame = 1e-7;

}  // namespace

Loop::Loop(Polygon points, std::vector<double> width_mm)
    : points_(std::move(points)), width_(std::move(width_mm)) {
  at_.reserve(points_.size() + 1);
  at_.push_back(0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    at_.push_back(at_.back() + (endOf(i) - points_[i]).norm());
    box_.include(points_[i]);
  }
}

double Loop::wrapped(double position) const {
  const double rest = std::fmod(position, length());
  const double positive = rest < 0.0 ? rest + length() : rest;
  return positive < length() ? positive : 0.0;
}

std::size_t Loop::edgeAt(double position) const {
  const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, position);
  return static_cast<std::size_t>(after - at_.begin()) - 1;
}

Point2 Loop::pointAt(double position) const {
  const double inside = wrapped(position);
  const std::size_t edge = edgeAt(inside);
  const double part = (inside - at_[edge]) / (at_[edge + 1] - at_[edge]);
  return points_[edge] + part * (endOf(edge) - points_[edge]);
}

double Loop::widthAt(double position) const { return edgeWidth(edgeAt(wrapped(position))); }

LoopPlace Loop::nearest(const Point2& point) const {
  EdgePlace best;
  std::size_t best_edge = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const EdgePlace place = nearestOnEdge(points_[i], endOf(i), point);
    if (place.squared >= best.squared) continue;
    best = place;
    best_edge = i;
  }
  return {at_[best_edge] + best.part * (at_[best_edge + 1] - at_[best_edge]), std::sqrt(best.squared)};
}

template <class Visit>
void Loop::visitEdges(const LoopStretch& stretch, const Visit& visit) const {
  const double start = wrapped(stretch.middle_mm - std::min(stretch.reach_mm, 0.5 * length()));
  std::size_t edge = edgeAt(start);
  double left = start - at_[edge] + 2.0 * stretch.reach_mm;
  for (std::size_t count = 0; count < points_.size() && left > 0.0; ++count) {
    visit(edge);
    left -= at_[edge + 1] - at_[edge];
    edge = edge + 1 < points_.size() ? edge + 1 : 0;
  }
}

LoopPlace Loop::nearest(const Point2& point, const LoopStretch& stretch) const {
  LoopPlace best{stretch.middle_mm, std::numeric_limits<double>::infinity()};
  visitEdges(stretch, [&](std::size_t edge) {
    const EdgePlace place = nearestOnEdge(points_[edge], endOf(edge), point);
    const double distance = std::sqrt(place.squared);
    if (distance < best.distance_mm) best = {at_[edge] + place.part * (at_[edge + 1] - at_[edge]), distance};
  });
  return best;
}

std::optional<LoopPlace> Loop::hit(const Point2& from, const Point2& direction,
                                   const LoopStretch& stretch) const {
  std::optional<LoopPlace> best;
  visitEdges(stretch, [&](std::size_t edge) {
    const Point2 along = endOf(edge) - points_[edge];
    const double turn = cross(direction, along);
    if (turn == 0.0) return;
    const double distance = cross(points_[edge] - from, along) / turn;
    const double part = cross(points_[edge] - from, direction) / turn;
    if (part < 0.0 || part > 1.0 || distance < 0.0 || (best && distance >= best->distance_mm)) return;
    best = LoopPlace{at_[edge] + part * (at_[edge + 1] - at_[edge]), distance};
  });
  return best;
}

bool Loop::isCrossedBy(const Point2& from, const Point2& to) const {
  const Point2 a = from + kTouching * (to - from);
  const Point2 b = to - kTouching * (to - from);
  const Point2 low = a.cwiseMin(b);
  const Point2 high = a.cwiseMax(b);
  if ((high.array() < box_.low.array()).any() || (low.array() > box_.high.array()).any()) return false;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (areCrossing(a, b, points_[i], endOf(i))) return true;
  return false;
}

LoopGraph::LoopGraph(std::vector<Loop> loops)
    : loops_(std::move(loops)),
      gaps_(loops_.size()),
      joints_(loops_.size()),
      group_(loops_.size()),
      members_(loops_.size()) {
  for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
    group_[loop] = loop;
    members_[loop] = {loop};
  }
}

std::size_t LoopGraph::groupOf(std::size_t loop) const { return group_[loop]; }

void LoopGraph::merge(std::size_t a, std::size_t b) {
  const std::size_t low = std::min(group_[a], group_[b]);
  const std::size_t high = std::max(group_[a], group_[b]);
  if (low == high) return;
  for (const std::size_t loop : members_[high]) group_[loop] = low;
  members_[low].insert(members_[low].end(), members_[high].begin(), members_[high].end());
  members_[high].clear();
}

bool LoopGraph::isFree(const LoopGap& gap, double margin_mm) const {
  const double length = loops_[gap.loop].length();
  if (gap.length() + margin_mm > length) return false;
  for (const LoopGap& made : gaps_[gap.loop]) {
    const double behind = loops_[gap.loop].wrapped(gap.from_mm - made.to_mm);
    const double ahead = loops_[gap.loop].wrapped(made.from_mm - gap.to_mm);
    // Both distances round the loop, with both gaps, make the whole loop if they do not overlap.
    if (behind < margin_mm || ahead < margin_mm) return false;
    if (std::abs(behind + ahead + gap.length() + made.length() - length) > 1e-6 * length) return false;
  }
  return true;
}

std::size_t LoopGraph::cut(const LoopGap& gap) {
  gaps_[gap.loop].push_back(gap);
  joints_[gap.loop].emplace_back();
  return gaps_[gap.loop].size() - 1;
}

void LoopGraph::joinEnds(const End& a, const End& b) {
  joints_[a.loop][a.gap].to[a.side] = b;
  joints_[b.loop][b.gap].to[b.side] = a;
  links_.push_back({pointOf(a), pointOf(b)});
}

Point2 LoopGraph::pointOf(const End& end) const {
  const LoopGap& gap = gaps_[end.loop][end.gap];
  return loops_[end.loop].pointAt(end.side == 0 ? gap.from_mm : gap.to_mm);
}

bool LoopGraph::isLinkCrossedBy(const Point2& from, const Point2& to) const {
  const Point2 low = from.cwiseMin(to);
  const Point2 high = from.cwiseMax(to);
  return std::any_of(links_.begin(), links_.end(), [&](const std::array<Point2, 2>& link) {
    if (std::max(link[0].x(), link[1].x()) < low.x() || std::min(link[0].x(), link[1].x()) > high.x() ||
        std::max(link[0].y(), link[1].y()) < low.y() || std::min(link[0].y(), link[1].y()) > high.y())
      return false;
    return areCrossing(link[0], link[1], from, to);
  });
}

void LoopGraph::join(const LoopGap& a, const LoopGap& b, LinkEnds ends) {
  const std::size_t gap_a = cut(a);
  const std::size_t gap_b = cut(b);
  for (const int side : {0, 1})
    joinEnds({a.loop, gap_a, side}, {b.loop, gap_b, ends == LinkEnds::Alike ? side : 1 - side});
  merge(a.loop, b.loop);
}

void LoopGraph::chain(const std::vector<LoopGap>& gaps) {
  std::optional<End> before;
  for (const LoopGap& gap : gaps) {
    const std::size_t index = cut(gap);
    if (before) {
      joinEnds(*before, {gap.loop, index, 1});
      merge(before->loop, gap.loop);
    }
    before = End{gap.loop, index, 0};
  }
}

/// Follows one line through the net.
class LoopGraph::Walk {
 public:
  explicit Walk(const LoopGraph& net) : net_(net) {}

  FillPath whole(std::size_t loop) {
    const Loop& only = net_.loops_[loop];
    path_.points = only.points();
    for (std::size_t i = 0; i < only.size(); ++i)
      path_.width_mm.push_back(only.edgeWidth(i > 0 ? i - 1 : only.size() - 1));
    path_.is_closed = true;
    return std::move(path_);
  }

  FillPath from(const End& start) {
    End at = start;
    put(net_.pointOf(at), 0.0);
    while (true) {
      const End end = alongLoop(at);
      const std::optional<End>& next = net_.joints_[end.loop][end.gap].to[end.side];
      if (!next) return std::move(path_);
      const double width = 0.5 * (widthAt(end) + widthAt(*next));
      if (next->loop == start.loop && next->gap == start.gap && next->side == start.side) {
        path_.width_mm.front() = width;
        path_.is_closed = true;
        return std::move(path_);
      }
      put(net_.pointOf(*next), width);
      at = *next;
    }
  }

 private:
  double positionOf(const End& end) const {
    const LoopGap& gap = net_.gaps_[end.loop][end.gap];
    return net_.loops_[end.loop].wrapped(end.side == 0 ? gap.from_mm : gap.to_mm);
  }
  double widthAt(const End& end) const { return net_.loops_[end.loop].widthAt(positionOf(end)); }

  void put(const Point2& point, double width) {
    if (!path_.points.empty() && (point - path_.points.back()).squaredNorm() < kSame * kSame) return;
    path_.points.push_back(point);
    path_.width_mm.push_back(width);
  }

  /// From an end of a gap, away from it, to the next gap.
  End alongLoop(const End& at) {
    const Loop& loop = net_.loops_[at.loop];
    const bool goes_forward = at.side == 1;
    const double start = positionOf(at);
    End end{at.loop, 0, 1 - at.side};
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t gap = 0; gap < net_.gaps_[at.loop].size(); ++gap) {
      const double there = positionOf({at.loop, gap, end.side});
      const double way = loop.wrapped(goes_forward ? there - start : start - there);
      if (way >= shortest) continue;
      shortest = way;
      end.gap = gap;
    }
    if (goes_forward)
      putForward(loop, start, shortest);
    else
      putBackward(loop, start, shortest);
    put(net_.pointOf(end), loop.widthAt(goes_forward ? start + shortest - kSame : start - shortest));
    return end;
  }

  void putForward(const Loop& loop, double start, double way) {
    std::size_t edge = loop.edgeAt(start);
    double gone = loop.positionOf(edge) - start;
    while (true) {
      gone += loop.positionOf(edge + 1) - loop.positionOf(edge);
      const std::size_t next = edge + 1 < loop.size() ? edge + 1 : 0;
      if (gone >= way) return;
      put(loop.points()[next], loop.edgeWidth(edge));
      edge = next;
    }
  }

  void putBackward(const Loop& loop, double start, double way) {
    std::size_t edge = loop.edgeAt(start);
    double gone = start - loop.positionOf(edge);
    while (gone < way) {
      put(loop.points()[edge], loop.edgeWidth(edge));
      edge = edge > 0 ? edge - 1 : loop.size() - 1;
      gone += loop.positionOf(edge + 1) - loop.positionOf(edge);
    }
  }

  const LoopGraph& net_;
  FillPath path_;
};

std::vector<FillPath> LoopGraph::lines() const {
  std::vector<std::optional<End>> start(loops_.size());  // of each group; open ends go first
  std::vector<bool> is_open(loops_.size(), false);
  for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
    const std::size_t group = groupOf(loop);
    for (std::size_t gap = 0; gap < gaps_[loop].size(); ++gap)
      for (const int side : {1, 0}) {
        const bool ends_here = !joints_[loop][gap].to[side];
        if (start[group] && (is_open[group] || !ends_here)) continue;
        start[group] = End{loop, gap, side};
        is_open[group] = ends_here;
      }
  }
  std::vector<FillPath> lines;
  for (std::size_t loop = 0; loop < loops_.size(); ++loop) {
    if (groupOf(loop) != loop) continue;
    Walk walk(*this);
    lines.push_back(start[loop] ? walk.from(*start[loop]) : walk.whole(loop));
  }
  return lines;
}

}  // namespace lamina
