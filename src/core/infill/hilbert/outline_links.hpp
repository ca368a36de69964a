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
  std::uint32_t edge = 0;    ///< starts at the outline's point of that index
  double distance_mm = 0.0;  ///< from there
};

/// An open run and where its ends lie on outlines, if they do.
struct RunOnOutlines {
  Polyline points;
  std::optional<OutlinePoint> first;
  std::optional<OutlinePoint> last;
};

/// Which of two links that share an end is made.
enum class LinkChoice {
  ShortestFirst,
  EveryOther,  ///< along each outline, from the place that joins more; then the shortest of the rest
};

/// Joins runs by links along the outlines: an end with the next one along its outline, if they belong to
/// different runs and the way is at most `longest_mm`. No run is closed. Links never pass an end of another
/// run, so that they meet no other link.
std::vector<Polyline> joinAlongOutlines(const std::vector<RunOnOutlines>& runs,
                                        const std::vector<Polygon>& outlines, double longest_mm,
                                        LinkChoice choice = LinkChoice::ShortestFirst);

}  // namespace lamina
