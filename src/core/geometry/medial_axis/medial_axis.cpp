// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/medial_axis/medial_axis.hpp"

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <boost/polygon/segment_utils.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/medial_axis/axis_graph.hpp"
#include "geometry/medial_axis/convex_axis.hpp"
#include "geometry/polygon/outline_crossings.hpp"
#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

using GridPoint = boost::polygon::point_data<int>;
/// From low() to high(), the material on its left.
using GridSegment = boost::polygon::segment_data<int>;

/// The border of a region on a grid, as the Voronoi diagram needs it.
struct BorderSegments {
  Point2 origin = Point2::Zero();     ///< where the grid's (0, 0) is [mm]
  double units_per_mm = 1e5;          ///< of the grid
  std::vector<GridSegment> segments;  ///< meet at their ends only
};

constexpr double kLargestMm = 20000.0;

void add(const Polygon& outline, BorderSegments& border) {
  std::vector<GridPoint> points;
  points.reserve(outline.size());
  for (const Point2& point : outline) {
    const Point2 at = (point - border.origin) * border.units_per_mm;
    points.emplace_back(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  }
  for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++)
    if (points[j] != points[i]) border.segments.emplace_back(points[j], points[i]);
}

/// The segments cut where they meet.
std::vector<GridSegment> cut(const std::vector<GridSegment>& segments) {
  std::vector<std::pair<std::size_t, GridSegment>> pieces;
  boost::polygon::intersect_segments(pieces, segments.begin(), segments.end());
  std::vector<GridSegment> result;
  result.reserve(pieces.size());
  for (const auto& [whole, piece] : pieces) {
    const GridSegment& original = segments[whole];
    const auto along = [](const GridSegment& s) {
      return std::pair<double, double>(double(s.high().x()) - s.low().x(),
                                       double(s.high().y()) - s.low().y());
    };
    const auto [ax, ay] = along(original);
    const auto [bx, by] = along(piece);
    if (ax * bx + ay * by >= 0.0)
      result.push_back(piece);
    else
      result.emplace_back(piece.high(), piece.low());
  }
  return result;
}

std::tuple<GridPoint, GridPoint> undirected(const GridSegment& segment) {
  return std::minmax(segment.low(), segment.high());
}

/// Of segments on each other keeps one if more run one way than the other, none if as many.
std::vector<GridSegment> withoutPairs(std::vector<GridSegment> segments) {
  std::stable_sort(segments.begin(), segments.end(),
                   [](const GridSegment& a, const GridSegment& b) { return undirected(a) < undirected(b); });
  std::vector<GridSegment> result;
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    int forward = 0;
    while (end < segments.size() && undirected(segments[end]) == undirected(segments[begin]))
      forward += segments[end].low() < segments[end].high() ? 1 : -1, ++end;
    const auto [low, high] = undirected(segments[begin]);
    if (forward != 0) result.emplace_back(forward > 0 ? low : high, forward > 0 ? high : low);
  }
  return result;
}

/// Segments of no length are left out, and those that lie on each other: one way and back, in pairs.
/// @throws InvalidInput if the region is larger than 20 m
BorderSegments borderSegments(const Region& region) {
  const std::vector<Polygon> borders = outlines({region});
  const Box2 box = boundingBox(borders);
  BorderSegments border;
  if (box.isEmpty()) return border;
  if (!(box.size().maxCoeff() <= kLargestMm))
    throw InvalidInput("a region is " + numberText(box.size().maxCoeff()) +
                       " mm large; its medial axis needs at most 20 m");
  border.origin = box.centre();
  for (const Polygon& outline : borders) add(outline, border);
  if (!areSurelyApart(borders)) border.segments = cut(border.segments);
  border.segments = withoutPairs(std::move(border.segments));
  return border;
}

/// What a piece of a medial axis is nearest to: an edge of the border or a corner.
struct ArcSite {
  Point2 from;
  Point2 to;  ///< `from` again for a corner
  bool is_segment = false;

  /// From the line through a segment, positive on its left; from a corner, never negative.
  double signedDistanceTo(const Point2& point) const;
  double distanceTo(const Point2& point) const;
};

/// The points as far from one site as from another: a line, or a parabola if they are an edge and a corner.
struct AxisArc {
  ArcSite first;
  ArcSite second;

  /// From one point of the arc to another; in between point and radius are within the tolerance of linear.
  /// Any unit of length.
  std::vector<AxisPoint> sampled(const Point2& from, const Point2& to, double tolerance) const;
};

/// Halvings of an arc at most: enough for 1e-5 mm on 10 m, and an end to whatever rounding does.
constexpr int kDeepest = 24;

/// The parabola of a focus and a line, over the line.
class Parabola {
 public:
  Parabola(const ArcSite& line, const Point2& focus)
      : origin_(line.from), along_((line.to - line.from).normalized()) {
    const double side = line.signedDistanceTo(focus);
    up_ = side < 0.0 ? rightOf(along_) : leftOf(along_);
    focus_at_ = along_.dot(focus - origin_);
    focus_height_ = std::abs(side);
  }

  bool isFlat() const { return !(focus_height_ > 0.0); }
  double positionOf(const Point2& point) const { return along_.dot(point - origin_); }
  Point2 at(double position) const {
    const double aside = position - focus_at_;
    const double height = (aside * aside + focus_height_ * focus_height_) / (2.0 * focus_height_);
    return origin_ + position * along_ + height * up_;
  }

 private:
  Point2 origin_;
  Point2 along_;
  Point2 up_;
  double focus_at_ = 0.0;
  double focus_height_ = 0.0;
};

/// Halves a piece of the arc until its middle is near enough to that of its ends.
/// @param middle  of two points of the arc
template <class Middle>
void halve(std::vector<AxisPoint>& points, const AxisPoint& to, const Middle& middle, double tolerance,
           int depth) {
  const AxisPoint from = points.back();
  const AxisPoint half = middle(from.point, to.point);
  const double bend = (half.point - 0.5 * (from.point + to.point)).norm();
  const double swell = std::abs(half.radius_mm - 0.5 * (from.radius_mm + to.radius_mm));
  if (depth < kDeepest && std::max(bend, swell) > tolerance) {
    halve(points, half, middle, tolerance, depth + 1);
    halve(points, to, middle, tolerance, depth + 1);
  } else {
    points.push_back(to);
  }
}

double ArcSite::signedDistanceTo(const Point2& point) const {
  if (!is_segment) return (point - from).norm();
  return cross((to - from).normalized(), point - from);
}

double ArcSite::distanceTo(const Point2& point) const { return std::abs(signedDistanceTo(point)); }

std::vector<AxisPoint> AxisArc::sampled(const Point2& from, const Point2& to, double tolerance) const {
  const ArcSite& nearest = first.is_segment ? second : first;
  const auto ended = [&](const Point2& point) { return AxisPoint{point, nearest.distanceTo(point)}; };
  std::vector<AxisPoint> points = {ended(from)};
  if (first.is_segment && second.is_segment) {
    points.push_back(ended(to));
    return points;
  }
  if (first.is_segment || second.is_segment) {
    const Parabola parabola(first.is_segment ? first : second, nearest.from);
    const auto middle = [&](const Point2& a, const Point2& b) {
      return ended(parabola.isFlat() ? Point2(0.5 * (a + b))
                                     : parabola.at(0.5 * (parabola.positionOf(a) + parabola.positionOf(b))));
    };
    halve(points, ended(to), middle, tolerance, 0);
  } else {
    const auto middle = [&](const Point2& a, const Point2& b) { return ended(0.5 * (a + b)); };
    halve(points, ended(to), middle, tolerance, 0);
  }
  return points;
}

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
    throw InvalidInput("tolerance of the medial axis is " + numberText(tolerance_mm) +
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
