// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace lamina {

/// The nozzle's pose moved back along the tool axis.
inline Eigen::Isometry3d backedOff(Eigen::Isometry3d pose, double way_mm) {
  pose.translation() -= way_mm * pose.linear().col(2);
  return pose;
}

}  // namespace lamina
