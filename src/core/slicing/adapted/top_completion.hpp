// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "slicing/adapted/growth.hpp"
#include "slicing/adapted/wall_growth.hpp"

namespace lamina {

/// Layers between the last adapted curve of a wall and the top of the part: grown towards the highest flat
/// contour where that is far enough, so that curves are open where the top is reached elsewhere. Open curves
/// end on the point next to them that is not grown. Where less than a layer is left, it is deposited as high
/// as it is if that is half of it at least.
///
/// @param mesh   the part, to show where it cannot be sliced
/// @param last   the last adapted curve
/// @param steps  coarse ones first; each is taken as long as there is room for it
/// @return layers of this wall; outlines where curves are open
/// @throws Unsliceable if the top is not reached by four times the layers its distance needs
std::vector<AdaptedLayer> completedTop(const Mesh& mesh, const WallStrand& strand, const Growth& growth,
                                       std::unique_ptr<PlacedCurve> last,
                                       const std::vector<GrowthStep>& steps);

}  // namespace lamina
