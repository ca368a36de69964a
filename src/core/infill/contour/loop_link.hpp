// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "infill/contour/loop_graph.hpp"
#include "lamina/infill/contour/contour_settings.hpp"

namespace lamina {

/// Two gaps opposite each other, to be joined.
struct LoopLink {
  LoopGap a;
  LoopGap b;
  LinkEnds ends = LinkEnds::Alike;
};

/// What makes a place fit for a link; all in parts of the distance between the loops.
struct LinkLimits {
  double straightness = 0.97;  ///< the chord of a gap over its length, at least
  double longest = 1.15;       ///< link
  double least_gap = 0.75;     ///< in the loop that is landed on
  double greatest_gap = 1.3;
  double margin = 0.8;  ///< to other gaps
};

/// Where loops are tried to be linked.
struct LinkTrial {
  std::size_t loop = 0;      ///< that is cut
  double position_mm = 0.0;  ///< where its gap begins
  std::size_t onto = 0;      ///< the loop that is landed on
  double distance_mm = 0.0;  ///< between the loops; the gap is nine tenths as long
};

/// The link at that place, none if it does not fit there. It crosses neither loop.
std::optional<LoopLink> linkAt(const LoopGraph& net, const LinkTrial& trial, ContourLink kind,
                               const LinkLimits& limits);

}  // namespace lamina
