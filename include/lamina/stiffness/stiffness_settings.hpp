// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/stiffness/elastic_material.hpp"

namespace lamina {

/// How a part is loaded [Vega2023, sections 7.1.2.3 and 7.2.2.7].
enum class Load {
  Compression,  ///< between two plates without friction, along the axis
  Bending,      ///< on two supports, by a punch half way between them that moves against the axis
};

/// Settings of `solveStiffness`.
struct StiffnessSettings {
  ElasticMaterial material;
  Load load = Load::Compression;
  int axis = 2;                 ///< of the load: 0, 1, 2 for x, y, z
  double compression_mm = 0.2;  ///< displacement of the plates towards each other
  double deflection_mm = 1.0;   ///< displacement of the punch
  double span_mm = 32.0;        ///< distance of the supports
  /// Cross-section that the equivalent solid has under compression; 0 for that of the box.
  double area_mm2 = 0.0;
  double residual = 1e-6;  ///< at which the solver stops: unbalanced forces over those at its start
  int iterations = 500;    ///< greatest number of iterations
  int memory_mb = 0;       ///< memory that may be used [MiB]; 0 for the free memory
};

/// Adds the keys stiffness.*.
void describe(SettingsSchema& schema, StiffnessSettings& settings);

}  // namespace lamina
