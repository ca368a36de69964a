// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Masses of a 6-RUS platform, and friction of its motors. The defaults are those of the Hunt platform
/// [Guacheta2021, table 1-1], with cranks and couplers as slender rods.
struct PlatformInertia {
  double platform_kg = 0.97;
  double crank_kg = 0.15;
  double coupler_kg = 0.18;
  /// Moments of inertia of the mobile platform about its centre of mass, along its axes [kg m²].
  Eigen::Vector3d platform_kg_m2{2766e-6, 2766e-6, 5503e-6};
  Point3 centre_mm = Point3::Zero();     ///< centre of mass of the mobile platform [platform frame]
  double viscous_friction = 0.0;         ///< of each motor [N m s/rad]; not published
  Eigen::Vector3d gravity{0, 0, -9.81};  ///< [m/s², base frame]
};

/// Adds the keys platform.*.
void describe(SettingsSchema& schema, PlatformInertia& inertia);

}  // namespace lamina
