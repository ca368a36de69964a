// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// Shift, from `sensorOffset`, of the point where the sensor's viewing axis meets a surface, per millimetre
/// by which the surface lies lower [x and y of the layer]. Zero if the sensor looks square to the layer, and
/// if the machine has none.
/// @param bed_from_layers  the identity for layers that are level
/// @throws InvalidConfig if the sensor does not look down on the layer
Point2 sensorLean(const BuildSpace& space,
                  const Eigen::Quaterniond& bed_from_layers = Eigen::Quaterniond::Identity());

}  // namespace lamina
