// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/sensor_lean.hpp"

#include "lamina/base/error.hpp"

namespace lamina {

Point2 sensorLean(const BuildSpace& space, const Eigen::Quaterniond& bed_from_layers) {
  constexpr double kUpright = 1e-9;  // below it, rounding of the description
  if (!space.tip_from_sensor) return Point2::Zero();
  const Point3 view = bed_from_layers.conjugate() * Point3(space.tip_from_sensor->linear().col(2));
  if (!(view.z() < 0.0))
    throw InvalidConfig("sensor of machine " + space.name + " does not look down on the layers");
  const Point2 lean = view.head<2>() / -view.z();
  return lean.norm() > kUpright ? lean : Point2::Zero();
}

}  // namespace lamina
