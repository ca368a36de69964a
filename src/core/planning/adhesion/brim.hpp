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
  std::vector<FillPath> runs;  ///< the farthest from the part first; open where bed or ears end them
  Regions area;
};

/// Loops round the first layer, a pitch apart, in the number that comes nearest to `brim.width_mm`. The
/// innermost one is half a pitch and `brim.gap_mm` off the part. Loops round neighbours that meet are one.
/// With `brim.ears` only the pieces within the brim's width of a convex corner sharper than 100 deg are left.
/// @param pitch_mm  distance of neighbouring beads
/// @param bed       area beyond which nothing is deposited; none if it is not known
Brim makeBrim(const Regions& first_layer, const BrimSettings& settings, double pitch_mm,
              const std::optional<Box2>& bed);

/// The pieces of a closed loop that lie within regions; the loop itself if all of it does.
std::vector<FillPath> piecesWithin(const Polygon& loop, const Regions& regions, PathRole role);

}  // namespace lamina
