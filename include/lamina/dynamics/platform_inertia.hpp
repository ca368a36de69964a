// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What of a 6-RUS platform has mass, and what brakes its motors. Defaults: the Hunt platform
/// [Guacheta2021, table 1-1], its cranks and couplers taken as slender rods.
struct PlatformInertia {
  double platform_kg = 0.97;
  double crank_kg = 0.15;
  double coupler_kg = 0.18;
  /// About its centre of mass, along its axes [kg m²].
  Eigen::Vector3d platform_kg_m2{2766e-6, 2766e-6, 5503e-6};
  Point3 centre_mm = Point3::Zero();     ///< of the mobile platform's mass [platform frame]
  double viscous_friction = 0.0;         ///< of each motor, not published [N m s/rad]
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< [m/s², base frame]
};

/// Adds the keys platform.*.
void describe(SettingsSchema& schema, PlatformInertia& inertia);

}  // namespace lamina
