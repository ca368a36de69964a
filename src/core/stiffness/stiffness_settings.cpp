// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, StiffnessSettings& settings) {
  schema.number("stiffness.youngs_modulus_mpa", settings.material.youngs_modulus_mpa, Bounds::above(0.0, 1e7),
                "Young's modulus of the material.");
  schema.number("stiffness.poissons_ratio", settings.material.poissons_ratio, {0.0, 0.49},
                "Poisson's ratio of the material; nearer to 0.5 the elements lock.");
  schema.choice("stiffness.load", settings.load,
                {{"compression", Load::Compression}, {"bending", Load::Bending}},
                "Between two plates, or on two supports by a punch half way between them.");
  schema.choice("stiffness.axis", settings.axis, {{"x", 0}, {"y", 1}, {"z", 2}},
                "Along which the load acts.");
  schema.number("stiffness.compression_mm", settings.compression_mm, Bounds::above(0.0, 1000.0),
                "By which the plates approach under compression.");
  schema.number("stiffness.deflection_mm", settings.deflection_mm, Bounds::above(0.0, 1000.0),
                "By which the punch moves under bending.");
  schema.number("stiffness.span_mm", settings.span_mm, Bounds::above(0.0, 1e5),
                "Between the supports under bending.");
  schema.number("stiffness.area_mm2", settings.area_mm2, {0.0, 1e10},
                "Section under compression as if solid; 0 for that of the box around the part.");
  schema.number("stiffness.residual", settings.residual, {1e-12, 0.1},
                "At which iterations stop: unbalanced forces over those at the start.");
  schema.integer("stiffness.iterations", settings.iterations, {1.0, 1e6}, "Iterations at most.");
  schema.integer("stiffness.memory_mb", settings.memory_mb, {0.0, 1e8},
                 "Memory that may be used, in MiB; 0 for what is free.");
}

}  // namespace lamina
