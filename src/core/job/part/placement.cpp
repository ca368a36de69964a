// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/placement.hpp"

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

/// The least value an axis takes over the corners of a box.
double leastValue(const Box3& box, const Eigen::Affine3d& axes_from_box, int axis) {
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    Point3 point = box.low;
    for (int i = 0; i < 3; ++i)
      if ((corner >> i & 1) != 0) point[i] = box.high[i];
    least = std::min(least, (axes_from_box * point)[axis]);
  }
  return least;
}

/// Tips of a path that deposits, and how low its beads reach.
void include(const Path& path, Box3& box) {
  if (path.role == PathRole::Travel) return;
  for (std::size_t w = 0; w < path.points.size(); ++w) {
    box.include(path.points[w]);
    const Point3 tool_axis = path.orientation.at(w) * Point3::UnitZ();
    const Point3 below(0, 0, path.bead.at(w).height_mm * tool_axis.z());
    box.include(Point3(path.points[w] + below));
  }
}

}  // namespace

Eigen::Isometry3d placePart(const Box3& part, const Point2& bed_centre, Placement placement) {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  if (placement == Placement::AsIs || part.isEmpty()) return bed_from_part;
  const Point3 centre = part.centre();
  bed_from_part.translation() =
      Point3(bed_centre.x() - centre.x(), bed_centre.y() - centre.y(), -part.low.z());
  return bed_from_part;
}

Eigen::Isometry3d placePart(const Box3& part, const BuildSpace& space, Placement placement) {
  Eigen::Isometry3d bed_from_part = placePart(part, boundingBox(space).centre().head<2>(), placement);
  if (placement == Placement::AsIs || part.isEmpty()) return bed_from_part;
  for (int i = 0; i < 3; ++i) {
    if (!space.is_endless[static_cast<std::size_t>(i)]) continue;
    const double least = leastValue(part, space.bed_from_axes.inverse() * bed_from_part, i);
    bed_from_part.pretranslate((space.range.low[i] - least) * space.bed_from_axes.linear().col(i));
  }
  return bed_from_part;
}

Eigen::Isometry3d placeDeposition(const Toolpath& toolpath, const BuildSpace& space) {
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) include(path, box);
  return placePart(box, space, Placement::Centre);
}

}  // namespace lamina
