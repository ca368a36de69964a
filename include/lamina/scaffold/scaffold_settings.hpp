// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a shape is filled inside its perimeters.
enum class ScaffoldFill {
  Rectilinear,  ///< parallel lines joined at the border, turned by 90 deg from layer to layer
  Concentric,   ///< rings parallel to the border
  Gyroid,       ///< what the layer cuts out of a gyroid
};

/// What lines are apart from each other where they fill a layer.
enum class FullSpacing {
  Packed,  ///< what a bead of stadium section fills: w - h (1 - pi/4)
  Width,   ///< the width of a bead: beads touch, and the layer is full to their section over w h
};

/// Line of the filaments of a sinusoidal scaffold.
enum class ScaffoldWave {
  Cosine,
  Sine,
  SineCosine,  ///< cosine in the first layer, sine in the next, and so on
};

/// How neighbouring filaments of a sinusoidal scaffold lie to each other.
enum class FilamentArrangement {
  Parallel,
  Mirrored,  ///< each is the mirror image of the one before; of sine waves only
};

/// A parametric part [Vega2023, sections 5.3, 7.1 and 7.2]. Which fields it takes depends on its
/// kind: see `makeScaffold`.
struct ScaffoldSettings {
  double corner_x_mm = 0.0;  ///< low corner of the part on the bed
  double corner_y_mm = 0.0;
  double length_mm = 9.0;   ///< along x; of cubes and sinusoidal scaffolds along y too
  double breadth_mm = 9.0;  ///< along y, of a box
  double diameter_mm = 10.0;
  double height_mm = 9.0;  ///< rounded to whole layers
  double layer_height_mm = 0.3;
  double first_layer_height_mm = 0.0;  ///< 0 takes that of the others
  double bead_width_mm = 0.48;
  double bead_fill = 0.0;  ///< section over width times height; 0 takes that of the kind
  double feed_mm_s = 20.0;
  double travel_feed_mm_s = 100.0;
  double away_mm = 0.0;  ///< by which the nozzle leaves the part between layers, along -x; 0 stays above it

  ScaffoldFill fill = ScaffoldFill::Rectilinear;
  FullSpacing full_spacing = FullSpacing::Packed;
  double density = 0.5;
  double angle_deg = 0.0;  ///< of the lines of the first layer
  int perimeters = 0;
  int solid_layers = 0;  ///< at the bottom, and as many at the top

  ScaffoldWave wave = ScaffoldWave::Sine;
  FilamentArrangement arrangement = FilamentArrangement::Parallel;
  double amplitude_mm = 0.5;
  int cycles = 5;     ///< of the wave along the length
  int filaments = 5;  ///< of a layer
  int cycle_segments = 20;
};

/// Adds the keys scaffold.*.
void describe(SettingsSchema& schema, ScaffoldSettings& settings);

}  // namespace lamina
