// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// A Hilbert curve over the bounding box of each region, turned by the requested angle and clipped at the
/// region's border. Pieces are joined along the border if the curve leaves the region and returns, or another
/// piece begins, at most `longestLink` along the border away; the others are separate runs.
///
/// If `hilbert.angles` is above 1, that many angles within a right angle are tried, for the fewest runs.
std::vector<FillPath> hilbert(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
