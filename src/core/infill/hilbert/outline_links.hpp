// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A place on one of several outlines.
struct OutlinePoint {
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;    ///< index of the outline's point at which the edge starts
  double distance_mm = 0.0;  ///< distance from that point
};

/// An open run, with the place of each end on the outlines if it lies on one.
struct RunOnOutlines {
  Polyline points;
  std::optional<OutlinePoint> first;
  std::optional<OutlinePoint> last;
};

/// Which of two links that share an end is chosen.
enum class LinkChoice {
  ShortestFirst,
  /// Along each outline every other link, beginning such that more are made; then the shortest of the rest.
  EveryOther,
};

/// Joins runs by links along outlines: an end is linked to the next end along its outline if they belong to
/// different runs and are at most `longest_mm` apart along it. Runs are never closed. Links do not pass an
/// end of another run, so that they do not meet each other.
std::vector<Polyline> joinAlongOutlines(const std::vector<RunOnOutlines>& runs,
                                        const std::vector<Polygon>& outlines, double longest_mm,
                                        LinkChoice choice = LinkChoice::ShortestFirst);

}  // namespace lamina
