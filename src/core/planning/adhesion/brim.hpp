// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/adhesion/adhesion_settings.hpp"

namespace lamina {

/// Loops that hold a part down, and the area that they cover.
struct Brim {
  std::vector<FillPath> runs;  ///< from the outside inwards; open where the bed's edge or an ear ends them
  Regions area;
};

/// Loops round the first layer, a pitch apart, in the number that comes nearest to `brim.width_mm`. The
/// innermost loop lies `brim.gap_mm` plus half a pitch from the part. Loops round neighbouring islands are
/// merged if they meet. With `brim.ears` only pieces of loops are kept, within the brim's width of a convex
/// corner sharper than 100 deg.
/// @param pitch_mm  distance of neighbouring beads
/// @param bed       area beyond which nothing is deposited; none if it is not known
Brim makeBrim(const Regions& first_layer, const BrimSettings& settings, double pitch_mm,
              const std::optional<Box2>& bed);

/// The pieces of a closed loop that lie within regions; the loop itself if it lies within them as a whole.
std::vector<FillPath> piecesWithin(const Polygon& loop, const Regions& regions, PathRole role);

}  // namespace lamina
