// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/platform_inertia.hpp"

namespace lamina {

void describe(SettingsSchema& schema, PlatformInertia& inertia) {
  const Bounds mass = Bounds::above(0.0, 1000.0);
  const Bounds turned = Bounds::above(0.0, 1000.0);
  schema.number("platform.mass_kg", inertia.platform_kg, mass, "Mass of the mobile platform with its tool.");
  schema.number("platform.crank_mass_kg", inertia.crank_kg, mass, "Mass of each crank, a slender rod.");
  schema.number("platform.coupler_mass_kg", inertia.coupler_kg, mass, "Mass of each coupler, a slender rod.");
  schema.number("platform.inertia_x_kg_m2", inertia.platform_kg_m2.x(), turned,
                "Moment of inertia of the mobile platform about its x, through its centre of mass.");
  schema.number("platform.inertia_y_kg_m2", inertia.platform_kg_m2.y(), turned, "The same about y.");
  schema.number("platform.inertia_z_kg_m2", inertia.platform_kg_m2.z(), turned, "The same about z.");
  schema.number("platform.centre_z_mm", inertia.centre_mm.z(), {-1000.0, 1000.0},
                "Height of the centre of mass over the middle of the platform's joints.");
  schema.number("platform.viscous_friction_nm_s", inertia.viscous_friction, {0.0, 1000.0},
                "Torque that brakes each motor, per rad/s of its crank.");
}

}  // namespace lamina
