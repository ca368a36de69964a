// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// A Hilbert curve over the box of each region, turned by the requested angle and cut off at the region's
/// border. Where the curve leaves the region and comes back, or another piece of it begins, no farther than
/// `longestLink` along the border, the pieces are joined along it; the rest are runs of their own.
///
/// With `hilbert.angles` above 1 the curve is turned by that many angles within a right angle, for the fewest
/// runs.
std::vector<FillPath> hilbert(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
