// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How walls are deposited whose bead lies partly beyond the layer below.
struct OverhangingWallSettings {
  bool is_used = false;
  /// Unsupported shares of the bead's width, ascending.
  std::vector<double> shares{0.25, 0.5, 0.75, 1.0};
  /// Factors on the feed at `shares`, linear between them.
  std::vector<double> feed_factors{1.0, 0.7, 0.5, 0.35};
  std::vector<double> flow_factors{1.0, 1.0, 1.0, 1.0};
  bool reverses = false;         ///< overhanging walls of every second layer run in the opposite direction
  double least_feed_mm_s = 0.0;  ///< lower bound of reduced feeds; from cooling.least_feed_mm_s
};

/// Adds the keys overhangs.*.
void describe(SettingsSchema& schema, OverhangingWallSettings& settings);

/// @throws InvalidConfig unless there are four shares that ascend within [0, 1], and four factors of feed and
///   of flow within (0, 3]
void requireConsistent(const OverhangingWallSettings& settings);

/// Unsupported share of a bead's width, 0 to 1.
/// @param beyond_mm  distance of the bead's outer edge beyond the layer below; negative if the edge lies on
///   that layer
double overhangShare(double beyond_mm, double width_mm);

/// Factor on the feed of a wall by its unsupported share: 1 below the first of `shares`, the last factor
/// above the last of `shares`.
double overhangFeedFactor(double share, const OverhangingWallSettings& settings);

/// Factor on the cross-section of a wall's bead by its unsupported share, by the same rule.
double overhangFlowFactor(double share, const OverhangingWallSettings& settings);

}  // namespace lamina
