// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// In which order sections of a raster are deposited.
enum class SectionOrder {
  Midpoints,  ///< greedy, by the midpoints of first and last lines [Flores2018, figures 52 and 53]
  Ends,       ///< greedy, by the end points of first and last lines
  Optimised,  ///< improved from there
};

/// Along which direction the lines of a raster run.
enum class RasterDirection {
  Given,        ///< that of `infill.angle_deg` and its alternation
  FewestTurns,  ///< that of each layer's own which takes the fewest lines
  LeastTravel,  ///< that of each layer's own which leaves the shortest way between runs
};

/// What the strategies of parallel lines ask for.
struct RasterSettings {
  RasterDirection direction = RasterDirection::Given;
  SectionOrder order = SectionOrder::Optimised;
  double narrowest = 0.3;               ///< bead of a solid raster, in pitches
  double longest_connection_mm = 50.0;  ///< along the border, from one section of a solid raster to the next
  double most_connection = 0.015;       ///< part of the area that all these connections may overfill
};

/// Adds the keys raster.*.
void describe(SettingsSchema& schema, RasterSettings& settings);

}  // namespace lamina
