// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/overhangs/overhanging_walls.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/overhangs/border_distance.hpp"

namespace lamina {

/// Name of the process value with the unsupported share of a bead's width.
inline constexpr const char* kUnsupported = "unsupported";

/// Rules for walls beyond the layer below.
struct OverhangRules {
  OverhangingWallSettings walls;
  double bridge_feed_mm_s = 0.0;  ///< of walls that span a gap; 0: as other walls
  double anchor_mm = 0.0;         ///< gaps shorter than this are ignored
};

/// A wall as it is deposited over the layer below. It gets a waypoint where its unsupported share passes an
/// entry of the settings. Feed and cross-section of a motion follow from the share at its middle; from the
/// first entry on the process value `unsupported` states the share. A straight unsupported stretch between
/// two supported ones spans a gap. A supported wall stays as it is.
/// @param below  border of the supporting material, with a reach of at least half the bead width
/// @param layer  index, from 0; in every second layer loops are reversed if the settings say so
Path overhanging(Path wall, const BorderDistance& below, const OverhangRules& rules, std::size_t layer);

/// Sets the feed of the depositing paths after the first `before` paths, and marks their beads as unsupported
/// as a whole by the process value.
void markUnsupportedSince(std::vector<Path>& paths, std::size_t before, double feed_mm_s);

/// The process value `unsupported` of a path; null if it has none.
const ProcessValue* unsupportedOf(const Path& path);

/// Removes the process value `unsupported`.
void forgetUnsupported(Path& path);

}  // namespace lamina
