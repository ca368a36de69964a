// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Where the tool axis of a run points before lead, tilt, smoothing and limits.
enum class OrientationMode {
  LayerNormal,  ///< as the slicer gave it: against the layer's normal
  Fixed,        ///< one direction everywhere
  Wall,         ///< in walls, along the wall and across the path; in other runs as the slicer gave it
};

/// One direction for the whole part: the nozzle's body leans from the vertical towards a heading.
struct FixedDirection {
  double lean_deg = 0.0;     ///< from the vertical; 0 is straight down
  double heading_deg = 0.0;  ///< to which the body leans, from x towards y
};

/// Which faces of a mesh are walls.
struct WallFaces {
  double max_lean_deg = 60.0;  ///< faces that lean more from the layers' normal are no walls
};

/// Limits on the orientation of the nozzle.
struct OrientationLimits {
  double max_lean_deg = 180.0;       ///< greatest angle of the tool axis from straight down; 180 is no limit
  double max_turn_deg_per_mm = 0.0;  ///< greatest turn of the tool axis along a run; 0 is no limit
  double max_off_normal_deg =
      60.0;  ///< of the tool axis from the layer's normal; a part that needs more is refused
};

/// How the nozzle is oriented along a toolpath.
struct OrientationSettings {
  OrientationMode mode = OrientationMode::LayerNormal;
  FixedDirection fixed;
  WallFaces wall;
  double lead_deg = 0.0;  ///< leans the nozzle's body towards the direction of travel
  /// Leans the nozzle's body to the left of the path, seen along the path from the nozzle.
  double tilt_deg = 0.0;
  int smoothing_window = 1;  ///< number of waypoints, odd; 1 is none
  OrientationLimits limits;
  double heading_deg = 0.0;  ///< direction of the nozzle's x, from x towards y
};

/// Adds the keys orientation.*. The former names `fixed_tilt_deg` of `fixed_lean_deg` and `max_tilt_deg` of
/// `max_lean_deg` are accepted for one release.
void describe(SettingsSchema& schema, OrientationSettings& settings);

/// Checks what the bounds of single keys do not cover.
/// @throws InvalidConfig if the smoothing window is even; or if there is a turn limit together with a lean
///   limit between 90 and 180 degrees, as interpolation between two tool axes within such a lean limit may
///   exceed the limit
void requireConsistent(const OrientationSettings& settings);

}  // namespace lamina
