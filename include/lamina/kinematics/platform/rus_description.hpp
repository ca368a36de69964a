// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/platform/rus_platform.hpp"

namespace lamina {

/// A 6-RUS platform as its URDF describes it, with its pose between bed and nozzle. The base frame is that of
/// the link that carries the cranks.
struct RusDescription {
  RusPlatform platform;
  std::vector<DrivenJoint> cranks;
  Eigen::Isometry3d root_from_base = Eigen::Isometry3d::Identity();        ///< [mm]
  Eigen::Isometry3d base_from_bed = Eigen::Isometry3d::Identity();         ///< [mm]
  Eigen::Isometry3d platform_from_nozzle = Eigen::Isometry3d::Identity();  ///< [mm]
};

/// Reads a platform: joints crank_i, universal_i_a, universal_i_b and spherical_i, links coupler_end_i, the
/// platform's joints platform_x, y, z, b, a, c, and links bed and nozzle (docs/machines/platform.md).
/// @throws InvalidConfig naming joint or link, and what was expected
RusDescription rusDescriptionFromUrdf(const std::string& text);

}  // namespace lamina
