// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/medial_axis/convex_axis.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/medial_axis/axis_graph.hpp"
#include "geometry/polygon/moving_edge.hpp"
#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// The work grows with the square of this.
constexpr std::size_t kMostCorners = 12;
/// Sine of the turn below which a corner is none.
constexpr double kLeastTurn = 1e-4;
/// Nodes nearer to each other are one [mm].
constexpr double kSamePlace = 1e-9;

bool isConvex(const Polygon& outline) {
  double turned = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& corner = outline[i];
    const Point2 in = corner - outline[i > 0 ? i - 1 : outline.size() - 1];
    const Point2 out = outline[i + 1 < outline.size() ? i + 1 : 0] - corner;
    if (!(cross(in, out) > kLeastTurn * in.norm() * out.norm())) return false;
    turned += turn(in, out);
  }
  return turned < 3.0 * M_PI;  // once round
}

class CollapsingOutline {
 public:
  explicit CollapsingOutline(const Polygon& outline) : graph_(0) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2 along = (outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i]).normalized();
      edges_.push_back({{outline[i], 0.0, along}, addNode({outline[i], 0.0})});
    }
  }

  MedialAxis axis() && {
    while (edges_.size() > 3) {
      const std::size_t first = firstToCollapse();
      const std::size_t node = nodeAt(first);
      reach(node, edges_[first].node);
      Edge& next = edges_[after(first)];
      reach(node, next.node);
      next = {{nodes_[node].point, nodes_[node].radius_mm, next.line.direction}, node};
      edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(first));
    }
    const std::size_t last = nodeAt(0);
    for (const Edge& edge : edges_) reach(last, edge.node);
    return std::move(graph_).joined();
  }

 private:
  struct Edge {
    MovingEdge line;
    std::size_t node;  ///< at its start
  };

  std::size_t after(std::size_t i) const { return i + 1 < edges_.size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : edges_.size() - 1; }

  AxisPoint meeting(std::size_t i) const {
    const EdgeCollapseEvent place =
        collapseBetween(edges_[before(i)].line, edges_[i].line, edges_[after(i)].line);
    return {place.point, place.moved_mm};
  }

  std::size_t firstToCollapse() const {
    std::size_t first = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const double radius = meeting(i).radius_mm;
      if (radius >= least) continue;
      least = radius;
      first = i;
    }
    return first;
  }

  std::size_t addNode(const AxisPoint& node) {
    nodes_.push_back(node);
    return graph_.addVertex();
  }

  /// The node where the edge vanishes. Others may have vanished in the same place.
  std::size_t nodeAt(std::size_t edge) {
    const AxisPoint place = meeting(edge);
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if ((nodes_[node].point - place.point).norm() < kSamePlace) return node;
    return addNode(place);
  }

  void reach(std::size_t node, std::size_t from) {
    if (from != node) graph_.add(from, node, {nodes_[from], nodes_[node]});
  }

  std::vector<Edge> edges_;
  std::vector<AxisPoint> nodes_;
  AxisGraph graph_;
};

}  // namespace

std::optional<MedialAxis> convexAxis(const Region& region) {
  if (!region.holes.empty() || region.outer.size() < 3 || region.outer.size() > kMostCorners ||
      !isConvex(region.outer))
    return std::nullopt;
  return CollapsingOutline(region.outer).axis();
}

}  // namespace lamina
