// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/overhangs/overhanging_walls.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/overhangs/border_distance.hpp"

namespace lamina {

/// The process value of paths that nothing carries: the share of the bead that has nothing below it.
inline constexpr const char* kUnsupported = "unsupported";

/// How walls beyond the layer below are laid.
struct OverhangRules {
  OverhangingWallSettings walls;
  double bridge_feed_mm_s = 0.0;  ///< of walls that span a gap; 0 if they are walls like others
  double anchor_mm = 0.0;         ///< shorter gaps do not count
};

/// A wall as it is laid over the layer below. Where the share of its bead that has nothing below it passes an
/// entry of the settings it gets a waypoint; feed and cross-section of each motion follow the share in the
/// middle of it, and the process value `unsupported` tells it from the first entry on. A straight stretch
/// with nothing below, between two that are carried, spans a gap. A wall that is carried stays as it is.
/// @param below  what carries it, to a reach of half the bead width at least
/// @param layer  index, from 0: of every second one loops are turned round if the settings say so
Path overhanging(Path wall, const BorderDistance& below, const OverhangRules& rules, std::size_t layer);

/// The same for paths that are wholly over nothing, those that follow the first so many and deposit: at that
/// feed, and told so.
void markUnsupportedSince(std::vector<Path>& paths, std::size_t before, double feed_mm_s);

/// What a path tells of it; null if it tells nothing.
const ProcessValue* unsupportedOf(const Path& path);

/// Takes it away.
void forgetUnsupported(Path& path);

}  // namespace lamina
