// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/medial_axis/medial_axis.hpp"

#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "geometry/medial_axis/axis_arc.hpp"
#include "geometry/medial_axis/axis_graph.hpp"
#include "geometry/medial_axis/border_segments.hpp"
#include "geometry/medial_axis/convex_axis.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Cell = Diagram::cell_type;
using Edge = Diagram::edge_type;
using Vertex = Diagram::vertex_type;

/// Vertices nearer to the border than this lie on it, in grid units.
constexpr double kOnBorder = 1.0;

enum class Side : std::uint8_t { Unknown, Inside, Outside };

Point2 toPoint(const GridPoint& point) { return {double(point.x()), double(point.y())}; }
Point2 toPoint(const Vertex& vertex) { return {vertex.x(), vertex.y()}; }

/// Reports which edges of the diagram are the medial axis.
class InsideEdges {
 public:
  InsideEdges(const BorderSegments& border, const Diagram& diagram)
      : border_(border), diagram_(diagram), sides_(diagram.num_edges(), Side::Unknown) {
    for (const GridSegment& segment : border.segments)
      for (const GridPoint& end : {segment.low(), segment.high()}) box_.include(toPoint(end));
    for (const Edge& edge : diagram.edges())
      if (isAxis(edge)) sides_[indexOf(edge)] = sideOf(edge);
    spread();
  }

  /// Each edge once, not its twin too.
  std::vector<const Edge*> list() const {
    std::vector<const Edge*> edges;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Edge& edge = diagram_.edges()[i];
      if (sides_[i] == Side::Inside && i < indexOf(*edge.twin())) edges.push_back(&edge);
    }
    return edges;
  }

  ArcSite siteOf(const Cell& cell) const {
    const GridSegment& segment = border_.segments[cell.source_index()];
    if (cell.contains_segment()) return {toPoint(segment.low()), toPoint(segment.high()), true};
    const bool is_start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    const Point2 at = toPoint(is_start ? segment.low() : segment.high());
    return {at, at, false};
  }

 private:
  /// Outlines that cross have no inside everywhere; at least nothing beyond their box is.
  bool isAxis(const Edge& edge) const {
    return edge.is_primary() && edge.is_finite() && isInBox(*edge.vertex0()) && isInBox(*edge.vertex1());
  }
  bool isInBox(const Vertex& vertex) const {
    const Point2 at = toPoint(vertex);
    return (at.array() >= box_.low.array() - kOnBorder).all() &&
           (at.array() <= box_.high.array() + kOnBorder).all();
  }
  std::size_t indexOf(const Edge& edge) const {
    return static_cast<std::size_t>(&edge - diagram_.edges().data());
  }

  double clearance(const Edge& edge) const {
    return siteOf(*edge.cell()).distanceTo(toPoint(*edge.vertex0()));
  }

  /// Material is on the left of each segment.
  Side sideOf(const Edge& edge) const {
    const Edge& of_segment = edge.cell()->contains_segment() ? edge : *edge.twin();
    if (!of_segment.cell()->contains_segment()) return Side::Unknown;
    const ArcSite site = siteOf(*of_segment.cell());
    const double first = site.signedDistanceTo(toPoint(*edge.vertex0()));
    const double second = site.signedDistanceTo(toPoint(*edge.vertex1()));
    return (std::abs(first) > std::abs(second) ? first : second) > 0.0 ? Side::Inside : Side::Outside;
  }

  /// Edges between two corners are on the side of those that they meet off the border.
  void spread() {
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (sides_[i] != Side::Unknown) known.push_back(i);
    while (!known.empty()) {
      const Edge& edge = diagram_.edges()[known.back()];
      known.pop_back();
      if (clearance(edge) < kOnBorder) continue;
      for (const Edge* next = edge.rot_next(); next != &edge; next = next->rot_next()) {
        if (!isAxis(*next) || sides_[indexOf(*next)] != Side::Unknown) continue;
        for (const Edge* half : {next, next->twin()}) {
          sides_[indexOf(*half)] = sides_[indexOf(edge)];
          known.push_back(indexOf(*half));
        }
      }
    }
  }

  const BorderSegments& border_;
  const Diagram& diagram_;
  Box2 box_;                 ///< of the border
  std::vector<Side> sides_;  ///< edge by edge
};

std::vector<AxisPoint> inMm(std::vector<AxisPoint> points, const BorderSegments& border) {
  for (AxisPoint& each : points) {
    each.point = border.origin + each.point / border.units_per_mm;
    each.radius_mm /= border.units_per_mm;
  }
  return points;
}

}  // namespace

MedialAxis medialAxis(const Region& region, double tolerance_mm) {
  if (!(tolerance_mm > 0.0))
    throw InvalidInput("tolerance of the medial axis is " + std::to_string(tolerance_mm) +
                       " mm; must be positive");
  const BorderSegments border = borderSegments(region);
  if (border.segments.size() < 3) return {};
  if (std::optional<MedialAxis> convex = convexAxis(region)) return std::move(*convex);
  Diagram diagram;
  boost::polygon::construct_voronoi(border.segments.begin(), border.segments.end(), &diagram);
  const InsideEdges inside(border, diagram);
  const auto indexOf = [&](const Vertex& vertex) {
    return static_cast<std::size_t>(&vertex - diagram.vertices().data());
  };
  AxisGraph graph(diagram.num_vertices());
  for (const Edge* edge : inside.list()) {
    const AxisArc arc = {inside.siteOf(*edge->cell()), inside.siteOf(*edge->twin()->cell())};
    const double tolerance = tolerance_mm * border.units_per_mm;
    std::vector<AxisPoint> points =
        arc.sampled(toPoint(*edge->vertex0()), toPoint(*edge->vertex1()), tolerance);
    graph.add(indexOf(*edge->vertex0()), indexOf(*edge->vertex1()), inMm(std::move(points), border));
  }
  return std::move(graph).joined();
}

}  // namespace lamina
