// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/shrinkage.hpp"

#include <Eigen/Geometry>
#include <cstdio>

#include "lamina/planning/compensation/compensation.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"

namespace lamina {

bool changesSize(const CompensationSettings& settings) {
  return settings.shrink_xy != 0.0 || settings.shrink_z != 0.0;
}

SourcePart grownForShrinkage(SourcePart source, const JobSettings& settings) {
  if (!changesSize(settings.compensation)) return source;
  const Box3 box = boundingBox(source.mesh);
  const Point3 middle(0.5 * (box.low.x() + box.high.x()), 0.5 * (box.low.y() + box.high.y()), box.low.z());
  const Eigen::Matrix3d part_from_layers = partFromLayers(settings.slicing.plane).toRotationMatrix();
  const Eigen::Matrix3d growth =
      part_from_layers * shrinkageFactors(settings.compensation).asDiagonal() * part_from_layers.transpose();
  for (Point3& vertex : source.mesh.vertices) vertex = middle + growth * (vertex - middle);
  Eigen::Affine3d grown = Eigen::Affine3d::Identity();
  grown.linear() = growth;
  grown.translation() = middle - growth * middle;
  source.part_from_file = grown * source.part_from_file;
  return source;
}

std::string sizeNote(const Point3& drawn, const Point3& deposited) {
  char text[192];
  std::snprintf(
      text, sizeof text,
      "the part is %.6g x %.6g x %.6g mm as drawn, and printed as %.6g x %.6g x %.6g mm, for it shrinks",
      drawn.x(), drawn.y(), drawn.z(), deposited.x(), deposited.y(), deposited.z());
  return text;
}

}  // namespace lamina
