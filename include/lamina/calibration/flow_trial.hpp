// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A trial of the flow: hollow squares of single walls in a row, each with another multiplier of the flow.
struct FlowTrialSettings {
  double x_mm = 100.0;  ///< middle of the row, on the bed
  double y_mm = 100.0;
  int squares = 7;
  double span = 0.15;     ///< multipliers run from 1 - span at the first square to 1 + span at the last
  double side_mm = 15.0;  ///< of each square, between the middles of its walls
  double gap_mm = 10.0;   ///< between neighbouring squares
  double height_mm = 6.0;
  double width_mm = 0.45;  ///< of the wall at a multiplier of 1
  double layer_mm = 0.2;
  double feed_mm_s = 30.0;
  double reading_mm = 0.02;  ///< standard deviation of a reading of a wall's thickness, at least
};

/// Adds the keys flow_trial.*.
void describe(SettingsSchema& schema, FlowTrialSettings& settings);

/// @throws InvalidConfig if squares are no wider than their walls, walls narrower than layers are high, or
///   the height is less than a layer
void requireConsistent(const FlowTrialSettings& settings);

/// The multipliers, in the order of the squares, towards +x.
std::vector<double> flowMultipliers(const FlowTrialSettings& settings);

/// The squares, layer by layer, in coordinates of the bed.
Toolpath flowTrialToolpath(const FlowTrialSettings& settings);

/// A measured wall.
struct FlowReading {
  double multiplier = 1.0;
  double section_mm2 = 0.0;  ///< of its bead
};

/// Readings of a table with the columns `multiplier` and either `thickness_mm`, of the walls as a caliper
/// grips them, or `section_mm2`, of their beads.
/// @throws InvalidInput naming source and line, also for a multiplier that is not above 0, and for a wall
///   thinner than the round sides of its beads
std::vector<FlowReading> flowReadings(const std::string& table, const std::string& source,
                                      const FlowTrialSettings& settings);

/// The extruded flow over the commanded flow.
struct FlowFit {
  double share = 1.0;         ///< mean over all walls; ideally 1
  double share_spread = 0.0;  ///< standard deviation
  double factor = 1.0;        ///< by which the flow has to be multiplied: 1 / share
  double factor_spread = 0.0;
  /// Share of a change of the multiplier that arrives, over `share`; ideally 1. It is less if the feeder
  /// slips, or all readings are too thick.
  double follows = 1.0;
  double follows_spread = 0.0;
  double rms_mm2 = 0.0;  ///< of the residuals of sections
  std::size_t readings = 0;
};

/// Fits the extruded flow by least squares: sections are proportional to their multipliers. The scatter of
/// the readings gives the spread, but not less than `flow_trial.reading_mm`.
/// @throws InvalidInput if there are fewer than three readings, or fewer than two different multipliers
FlowFit fitFlow(const std::vector<FlowReading>& readings, const FlowTrialSettings& settings);

}  // namespace lamina
