// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <queue>

#include "geometry/medial_axis/axis_graph.hpp"
#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNoEnd = std::numeric_limits<std::size_t>::max();

class WayFinder {
 public:
  explicit WayFinder(const MedialAxis& axis) : axis_(axis), graph_(axis) {}

  MedialAxis longest() const {
    std::size_t tip = 0;
    while (tip < axis_.nodes.size() && graph_.degree(tip) != 1) ++tip;
    if (tip == axis_.nodes.size()) return axis_;
    const std::size_t start = farthestTip(tip);
    return way(start, farthestTip(start));
  }

 private:
  std::size_t farthestTip(std::size_t from) const {
    std::size_t farthest = from;
    double most = 0.0;
    for (std::size_t node = 0; node < axis_.nodes.size(); ++node) {
      const double distance = (axis_.nodes[node].point - axis_.nodes[from].point).norm();
      if (graph_.degree(node) == 1 && distance > most) most = distance, farthest = node;
    }
    return farthest;
  }

  /// The piece by which each node is reached from there first.
  std::vector<std::size_t> piecesFrom(std::size_t from) const {
    std::vector<std::size_t> reached(axis_.nodes.size(), kNoEnd);
    std::queue<std::size_t> open({from});
    while (!open.empty()) {
      const std::size_t node = open.front();
      open.pop();
      for (const std::size_t piece : graph_.piecesAt(node)) {
        const std::size_t next = graph_.otherEnd(piece, node);
        if (next == from || reached[next] != kNoEnd) continue;
        reached[next] = piece;
        open.push(next);
      }
    }
    return reached;
  }

  MedialAxis way(std::size_t from, std::size_t to) const {
    const std::vector<std::size_t> reached = piecesFrom(from);
    if (from == to || reached[to] == kNoEnd) return axis_;
    MedialAxis way;
    AxisBranch branch{0, 1, {}};
    for (std::size_t node = to; node != from; node = graph_.otherEnd(reached[node], node)) {
      const std::vector<AxisPoint> points = graph_.pointsFrom(reached[node], node);
      branch.points.insert(branch.points.end(), points.begin() + (branch.points.empty() ? 0 : 1),
                           points.end());
    }
    way.nodes = {axis_.nodes[to], axis_.nodes[from]};
    way.branches.push_back(std::move(branch));
    return way;
  }

  const MedialAxis& axis_;
  AxisGraph graph_;
};

}  // namespace

MedialAxis farthestWay(const MedialAxis& axis) { return WayFinder(axis).longest(); }

}  // namespace lamina
