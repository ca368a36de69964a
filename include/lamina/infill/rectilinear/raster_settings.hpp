// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// In which order sections of a raster are deposited.
enum class SectionOrder {
  Midpoints,  ///< greedy, by the midpoints of first and last lines [Flores2018, figures 52 and 53]
  Ends,       ///< greedy, by the end points of first and last lines
  Optimised,  ///< as `Ends`, then improved
};

/// How the direction of a raster's lines is chosen.
enum class RasterDirection {
  Given,        ///< by `infill.angle_deg` and its alternation
  FewestTurns,  ///< in each layer the direction with the fewest lines
  LeastTravel,  ///< in each layer the direction with the shortest travels between runs
};

/// Settings of the strategies of parallel lines.
struct RasterSettings {
  RasterDirection direction = RasterDirection::Given;
  SectionOrder order = SectionOrder::Optimised;
  double narrowest = 0.3;  ///< least width of a bead in a solid raster, in pitches
  /// Greatest length of a connection along the border between two sections of a solid raster; 0 for none.
  double longest_connection_mm = 50.0;
  double most_connection = 0.015;  ///< greatest share of the area that all connections together overfill
};

/// Adds the keys raster.*.
void describe(SettingsSchema& schema, RasterSettings& settings);

}  // namespace lamina
