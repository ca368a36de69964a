// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The plane in which x · up = from; what lies on it within a millionth of a millimetre is below it.
struct CuttingPlane {
  Point3 up = Point3::UnitZ();
  double from_mm = 0.0;

  double heightOf(const Point3& point) const { return up.dot(point) - from_mm; }
  bool isBelow(const Point3& point) const { return heightOf(point) <= 1e-6; }
};

/// Faces of a part, some of them cut: convex polygons [mm].
class FacePolygons {
 public:
  explicit FacePolygons(const Mesh& mesh);

  std::uint32_t count() const { return static_cast<std::uint32_t>(normals_.size()); }
  const Point3& normal(std::uint32_t face) const { return normals_[face]; }
  const Point3* begin(std::uint32_t face) const { return corners_.data() + first_[face]; }
  const Point3* end(std::uint32_t face) const { return corners_.data() + first_[face + 1]; }
  double area(std::uint32_t face) const { return areas_[face]; }

  /// What of them is below a plane, without what would close the cut.
  FacePolygons below(const CuttingPlane& plane) const;
  /// Area of what of a face is above a plane.
  double areaAbove(std::uint32_t face, const CuttingPlane& plane) const;
  /// Triangles of the chosen faces.
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
