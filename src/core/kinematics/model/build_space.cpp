// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/build_space.hpp"

#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {

Box3 boundingBox(const BuildSpace& space) {
  const Eigen::Matrix3d edges = space.bed_from_axes.linear();
  Box3 box;
  for (int corner = 0; corner < 8; ++corner) {
    Point3 values = space.range.low;
    for (int i = 0; i < 3; ++i)
      if ((corner >> i & 1) != 0) values[i] = space.range.high[i];
    box.include(Point3(edges * values + space.bed_from_axes.translation()));
  }
  return box;
}

Point3 toolAxis(const BuildSpace& space) { return space.bed_from_nozzle.col(2); }

bool canTurnToolAxis(const BuildSpace& space) { return !space.rotary_joints.empty(); }

BuildSpace withUprightHead(BuildSpace space) {
  space.bed_from_nozzle = nozzleDown().toRotationMatrix();
  return space;
}

Point2 sensorOffset(const BuildSpace& space, const Eigen::Quaterniond& bed_from_layers) {
  if (!space.tip_from_sensor) return Point2::Zero();
  const Eigen::Matrix3d layers_from_bed = bed_from_layers.conjugate().toRotationMatrix();
  const Point3 position = layers_from_bed * space.tip_from_sensor->translation();
  const Point3 view = layers_from_bed * space.tip_from_sensor->linear().col(2);
  if (!(view.z() < 0.0))
    throw InvalidConfig("sensor of machine " + space.name + " does not look down on the layers");
  return (position - view * (position.z() / view.z())).head<2>();
}

}  // namespace lamina
