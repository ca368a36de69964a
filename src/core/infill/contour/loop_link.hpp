// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "infill/contour/loop_graph.hpp"
#include "lamina/infill/contour/contour_settings.hpp"

namespace lamina {

/// Two gaps opposite each other that a link pair joins.
struct LoopLink {
  LoopGap a;
  LoopGap b;
  LinkEnds ends = LinkEnds::Alike;
};

/// Conditions for a link; lengths are relative to the distance between the loops.
struct LinkLimits {
  double straightness = 0.97;  ///< least ratio of a gap's chord to its length
  double longest = 1.15;       ///< greatest length of a link
  double least_gap = 0.75;     ///< least gap in the loop that the link leads to
  double greatest_gap = 1.3;
  double margin = 0.8;  ///< least distance from other gaps
};

/// A place at which a link is tried.
struct LinkTrial {
  std::size_t loop = 0;      ///< the loop that is cut
  double position_mm = 0.0;  ///< position at which its gap begins
  std::size_t onto = 0;      ///< the loop that the link leads to
  double distance_mm = 0.0;  ///< distance between the loops; the gap is nine tenths of it
};

/// The link at that place; nothing if it does not meet the conditions. It crosses neither loop.
std::optional<LoopLink> linkAt(const LoopGraph& net, const LinkTrial& trial, ContourLink kind,
                               const LinkLimits& limits);

}  // namespace lamina
