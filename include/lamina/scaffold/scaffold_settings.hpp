// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a shape is filled inside its perimeters.
enum class ScaffoldFill {
  Rectilinear,  ///< parallel lines joined at the border, turned by 90 deg from layer to layer
  Concentric,   ///< rings parallel to the border
  Gyroid,       ///< the curves in which the plane of the layer cuts a gyroid
};

/// Distance between the lines of a layer that is filled completely.
enum class FullSpacing {
  Packed,  ///< w - h (1 - pi/4), at which beads with a stadium section have the volume of the layer
  Width,   ///< the bead width w: beads touch, and have less volume than the layer
};

/// Curve of the filaments of a sinusoidal scaffold.
enum class ScaffoldWave {
  Cosine,
  Sine,
  SineCosine,  ///< one in the first layer, the other in the second, and so on (`FirstWave`)
};

/// Which wave the first layer has where sine and cosine alternate.
enum class FirstWave {
  Sine,  ///< sine in odd layers, the first one being 1, and cosine in even ones, as [Vega2023,
         ///< section 7.2.1.1]
  Cosine,
};

/// How neighbouring filaments of a sinusoidal scaffold are arranged.
enum class FilamentArrangement {
  Parallel,
  Mirrored,  ///< each is the mirror image of the one before; for Sine only
};

/// Parameters of a parametric part [Vega2023, sections 5.3, 7.1 and 7.2]. Which of them are used depends on
/// the kind of part (`makeScaffold`).
struct ScaffoldSettings {
  double corner_x_mm = 0.0;  ///< x of the low corner of the part on the bed
  double corner_y_mm = 0.0;  ///< y of that corner
  double length_mm = 9.0;    ///< size along x; of cubes and sinusoidal scaffolds along y, too
  double breadth_mm = 9.0;   ///< size of a box along y
  double diameter_mm = 10.0;
  double height_mm = 9.0;  ///< rounded to whole layers
  double layer_height_mm = 0.3;
  double first_layer_height_mm = 0.0;  ///< 0 for that of the other layers
  double bead_width_mm = 0.48;
  double bead_fill = 0.0;  ///< cross-section of a bead over width times height; 0 for that of the kind
  double feed_mm_s = 20.0;
  double travel_feed_mm_s = 100.0;
  double away_mm = 0.0;  ///< distance to which the nozzle leaves the part along -x between layers; 0 for not

  ScaffoldFill fill = ScaffoldFill::Rectilinear;
  FullSpacing full_spacing = FullSpacing::Packed;
  double density = 0.5;    ///< of the fill, as a share of the volume
  double angle_deg = 0.0;  ///< direction of the lines of the first layer
  int perimeters = 0;      ///< number of perimeters
  int solid_layers = 0;    ///< number of solid layers at the bottom, and again at the top

  ScaffoldWave wave = ScaffoldWave::Sine;
  FirstWave first_wave = FirstWave::Sine;  ///< for SineCosine only
  FilamentArrangement arrangement = FilamentArrangement::Parallel;
  double amplitude_mm = 0.5;  ///< of the wave
  int cycles = 5;             ///< number of cycles of the wave along the length
  int filaments = 5;          ///< number of filaments of a layer
  int cycle_segments = 20;    ///< number of straight motions by which a cycle is approximated
};

/// Adds the keys scaffold.*.
void describe(SettingsSchema& schema, ScaffoldSettings& settings);

}  // namespace lamina
