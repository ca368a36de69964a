// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/stiffness/elastic_material.hpp"

namespace lamina {

/// How a part is loaded [Vega2023, sections 7.1.2.3 and 7.2.2.7].
enum class Load {
  Compression,  ///< between two plates without friction, along the axis
  Bending,      ///< on two supports by a punch half way between them, pressing against the axis
};

/// What is computed of a part's stiffness, and how.
struct StiffnessSettings {
  ElasticMaterial material;
  Load load = Load::Compression;
  int axis = 2;                 ///< of the load: 0, 1, 2 for x, y, z
  double compression_mm = 0.2;  ///< by which the plates approach
  double deflection_mm = 1.0;   ///< by which the punch moves
  double span_mm = 32.0;        ///< between the supports
  double area_mm2 = 0.0;        ///< of the section under compression as if solid; 0 for that of the box
  double residual = 1e-6;       ///< at which iterations stop: unbalanced forces over those at the start
  int iterations = 500;         ///< at most
  int memory_mb = 0;            ///< that may be used [MiB]; 0 for what is free
};

/// Adds the keys stiffness.*.
void describe(SettingsSchema& schema, StiffnessSettings& settings);

}  // namespace lamina
