// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/voxel/height_grid.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// Indices of a chart and of a triangle within it.
struct ChartTriangle {
  std::uint32_t chart = 0;
  std::uint32_t triangle = 0;
};

/// A place in a triangle of a chart.
struct ChartPlace {
  ChartTriangle in;
  /// Barycentric coordinates: weights of the triangle's corners, not negative, with the sum 1.
  Point3 weights = Point3::Zero();
};

/// Geometry of a layer at one place.
struct SurfacePoint {
  Point3 middle = Point3::Zero();  ///< on the middle surface [mm, part frame]
  Point3 tip = Point3::Zero();     ///< of the nozzle [mm, part frame]
  Point3 normal = Point3::UnitZ();
  double height_mm = 0.0;
};

/// The segment of a straight line of the parameter plane that lies in one triangle, as an interval of
/// fractions of the line's length.
struct ChartStretch {
  ChartTriangle in;
  double from = 0.0;  ///< 0 is the line's start
  double to = 0.0;    ///< 1 is the line's end
};

/// Grid lookup of triangles by points and lines of the parameter plane, and the mapping of points from that
/// plane back into space [Guacheta2021, section 2.3.1]. The time of `find` hardly depends on the number of
/// triangles. Queries may be made from several threads.
class ChartLookup {
 public:
  /// Distance from a chart within which a point of the parameter plane is moved to the chart's border [mm].
  /// Planned paths may lie slightly outside: outlines are simplified by `planning.simplification_mm`, whose
  /// default is a tenth of this, and thin beads cut the corners of notches.
  static constexpr double kSnap = 0.05;

  /// @param charts  must outlive the lookup; their parameterizations do not overlap
  /// @throws InvalidInput if there is no triangle, or a vertex of a chart has no finite position, parameter
  ///   point, tip, normal or height
  explicit ChartLookup(const std::vector<LayerChart>& charts);

  /// The place of a point of the parameter plane; nothing if it is farther than `kSnap` from all charts. A
  /// point on an edge is in the triangle of the lowest number.
  std::optional<ChartPlace> find(const Point2& parameters) const;

  /// The place of a point, as by `find`.
  /// @throws InvalidInput naming the point if there is none
  ChartPlace at(const Point2& parameters) const;

  /// The place of a point in a given triangle; points outside are moved to its border.
  ChartPlace within(const ChartTriangle& in, const Point2& parameters) const;

  /// Middle, tip, normal and height at a place, interpolated between those of the corners.
  SurfacePoint lifted(const ChartPlace& place) const;

  /// Area of a triangle in space over its area in the parameter plane.
  double areaRatio(const ChartTriangle& in) const;

  /// A straight line of the parameter plane, cut where it crosses sides of triangles, in order and without
  /// gaps. All stretches lie in one chart if one chart holds the whole line. Otherwise they may pass from
  /// chart to chart, because level charts of equal height may touch. Nothing if the line leaves the charts by
  /// more than `kSnap`.
  std::optional<std::vector<ChartStretch>> stretches(const Point2& from, const Point2& to) const;

 private:
  using Corners = std::array<Point2, 3>;
  enum class Over { OneChart, AnyChart };
  struct Crossing {
    double margin_mm;  ///< by which triangles are widened
    Over over;
  };

  void sort(const Box2& box);
  Corners parametersOf(const ChartTriangle& in) const;
  template <class Visit>
  void forCellsOf(const Corners& corners, const Visit& visit) const;
  std::optional<std::vector<ChartStretch>> covering(const Point2& from, const Point2& to,
                                                    const std::vector<std::uint32_t>& candidates,
                                                    Crossing crossing) const;

  const std::vector<LayerChart>& charts_;
  std::vector<ChartTriangle> triangles_;  // of all charts
  HeightGrid grid_;
  std::vector<std::uint32_t> first_;  // index in items_ of the first item of each cell, and the end
  std::vector<std::uint32_t> items_;  // indices in triangles_, grouped by cell
};

}  // namespace lamina
