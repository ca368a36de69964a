// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Points nearer to each other than this are one [mm].
constexpr double kSame = 1e-7;

}  // namespace

RingNet::RingNet(std::vector<Ring> rings)
    : rings_(std::move(rings)), gaps_(rings_.size()), joints_(rings_.size()), parent_(rings_.size()) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

std::size_t RingNet::groupOf(std::size_t ring) const {
  while (parent_[ring] != ring) ring = parent_[ring];
  return ring;
}

void RingNet::merge(std::size_t a, std::size_t b) {
  const std::size_t low = std::min(groupOf(a), groupOf(b));
  for (std::size_t ring : {a, b}) {
    while (parent_[ring] != ring) ring = std::exchange(parent_[ring], low);
    parent_[ring] = low;
  }
}

bool RingNet::isFree(const RingGap& gap, double margin_mm) const {
  const double length = rings_[gap.ring].length();
  if (gap.length() + margin_mm > length) return false;
  for (const RingGap& made : gaps_[gap.ring]) {
    const double behind = rings_[gap.ring].wrapped(gap.from_mm - made.to_mm);
    const double ahead = rings_[gap.ring].wrapped(made.from_mm - gap.to_mm);
    // Both distances round the ring, with both gaps, make the whole ring if they do not overlap.
    if (behind < margin_mm || ahead < margin_mm) return false;
    if (std::abs(behind + ahead + gap.length() + made.length() - length) > 1e-6 * length) return false;
  }
  return true;
}

std::size_t RingNet::cut(const RingGap& gap) {
  gaps_[gap.ring].push_back(gap);
  joints_[gap.ring].emplace_back();
  return gaps_[gap.ring].size() - 1;
}

void RingNet::joinEnds(const End& a, const End& b) {
  joints_[a.ring][a.gap].to[a.side] = b;
  joints_[b.ring][b.gap].to[b.side] = a;
  links_.push_back({pointOf(a), pointOf(b)});
}

Point2 RingNet::pointOf(const End& end) const {
  const RingGap& gap = gaps_[end.ring][end.gap];
  return rings_[end.ring].pointAt(end.side == 0 ? gap.from_mm : gap.to_mm);
}

bool RingNet::isLinkCrossedBy(const Point2& from, const Point2& to) const {
  return std::any_of(links_.begin(), links_.end(), [&](const std::array<Point2, 2>& link) {
    return areCrossing(link[0], link[1], from, to);
  });
}

void RingNet::join(const RingGap& a, const RingGap& b, LinkEnds ends) {
  const std::size_t gap_a = cut(a);
  const std::size_t gap_b = cut(b);
  for (const int side : {0, 1})
    joinEnds({a.ring, gap_a, side}, {b.ring, gap_b, ends == LinkEnds::Alike ? side : 1 - side});
  merge(a.ring, b.ring);
}

void RingNet::chain(const std::vector<RingGap>& gaps) {
  std::optional<End> before;
  for (const RingGap& gap : gaps) {
    const std::size_t index = cut(gap);
    if (before) {
      joinEnds(*before, {gap.ring, index, 1});
      merge(before->ring, gap.ring);
    }
    before = End{gap.ring, index, 0};
  }
}

/// Follows one line through the net.
class RingNet::Walk {
 public:
  explicit Walk(const RingNet& net) : net_(net) {}

  FillPath whole(std::size_t ring) {
    const Ring& only = net_.rings_[ring];
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
      const End end = alongRing(at);
      const std::optional<End>& next = net_.joints_[end.ring][end.gap].to[end.side];
      if (!next) return std::move(path_);
      const double width = 0.5 * (widthAt(end) + widthAt(*next));
      if (next->ring == start.ring && next->gap == start.gap && next->side == start.side) {
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
    const RingGap& gap = net_.gaps_[end.ring][end.gap];
    return net_.rings_[end.ring].wrapped(end.side == 0 ? gap.from_mm : gap.to_mm);
  }
  double widthAt(const End& end) const { return net_.rings_[end.ring].widthAt(positionOf(end)); }

  void put(const Point2& point, double width) {
    if (!path_.points.empty() && (point - path_.points.back()).squaredNorm() < kSame * kSame) return;
    path_.points.push_back(point);
    path_.width_mm.push_back(width);
  }

  /// From an end of a gap, away from it, to the next gap.
  End alongRing(const End& at) {
    const Ring& ring = net_.rings_[at.ring];
    const bool goes_forward = at.side == 1;
    const double start = positionOf(at);
    End end{at.ring, 0, 1 - at.side};
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t gap = 0; gap < net_.gaps_[at.ring].size(); ++gap) {
      const double there = positionOf({at.ring, gap, end.side});
      const double way = ring.wrapped(goes_forward ? there - start : start - there);
      if (way >= shortest) continue;
      shortest = way;
      end.gap = gap;
    }
    if (goes_forward)
      putForward(ring, start, shortest);
    else
      putBackward(ring, start, shortest);
    put(net_.pointOf(end), ring.widthAt(goes_forward ? start + shortest - kSame : start - shortest));
    return end;
  }

  void putForward(const Ring& ring, double start, double way) {
    std::size_t edge = ring.edgeAt(start);
    double gone = ring.positionOf(edge) - start;
    while (true) {
      gone += ring.positionOf(edge + 1) - ring.positionOf(edge);
      const std::size_t next = edge + 1 < ring.size() ? edge + 1 : 0;
      if (gone >= way) return;
      put(ring.points()[next], ring.edgeWidth(edge));
      edge = next;
    }
  }

  void putBackward(const Ring& ring, double start, double way) {
    std::size_t edge = ring.edgeAt(start);
    double gone = start - ring.positionOf(edge);
    while (gone < way) {
      put(ring.points()[edge], ring.edgeWidth(edge));
      edge = edge > 0 ? edge - 1 : ring.size() - 1;
      gone += ring.positionOf(edge + 1) - ring.positionOf(edge);
    }
  }

  const RingNet& net_;
  FillPath path_;
};

std::vector<FillPath> RingNet::lines() const {
  std::vector<std::optional<End>> start(rings_.size());  // of each group; open ends go first
  std::vector<bool> is_open(rings_.size(), false);
  for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
    const std::size_t group = groupOf(ring);
    for (std::size_t gap = 0; gap < gaps_[ring].size(); ++gap)
      for (const int side : {1, 0}) {
        const bool ends_here = !joints_[ring][gap].to[side];
        if (start[group] && (is_open[group] || !ends_here)) continue;
        start[group] = End{ring, gap, side};
        is_open[group] = ends_here;
      }
  }
  std::vector<FillPath> lines;
  for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
    if (groupOf(ring) != ring) continue;
    Walk walk(*this);
    lines.push_back(start[ring] ? walk.from(*start[ring]) : walk.whole(ring));
  }
  return lines;
}

}  // namespace lamina
