// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The plane x · up = from. What lies on it, within 1e-6 mm, counts as below it.
struct CuttingPlane {
  Point3 up = Point3::UnitZ();
  double from_mm = 0.0;

  double heightOf(const Point3& point) const { return up.dot(point) - from_mm; }
  bool isBelow(const Point3& point) const { return heightOf(point) <= 1e-6; }
};

/// Faces of a part as convex polygons, some of them cut [mm].
class FacePolygons {
 public:
  explicit FacePolygons(const Mesh& mesh);

  std::uint32_t count() const { return static_cast<std::uint32_t>(normals_.size()); }
  const Point3& normal(std::uint32_t face) const { return normals_[face]; }
  const Point3* begin(std::uint32_t face) const { return corners_.data() + first_[face]; }
  const Point3* end(std::uint32_t face) const { return corners_.data() + first_[face + 1]; }
  double area(std::uint32_t face) const { return areas_[face]; }

  /// The faces, or parts of faces, below a plane. The cut is left open.
  FacePolygons below(const CuttingPlane& plane) const;
  /// Area of that part of a face that is above a plane [mm²].
  double areaAbove(std::uint32_t face, const CuttingPlane& plane) const;
  /// The chosen faces as triangles.
  Mesh meshOf(const std::vector<std::uint32_t>& faces) const;

 private:
  FacePolygons() = default;
  void add(const std::vector<Point3>& polygon, const Point3& normal);

  std::vector<Point3> corners_;
  std::vector<std::uint32_t> first_{0};
  std::vector<Point3> normals_;
  std::vector<double> areas_;
};

}  // namespace lamina
