// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// N perimeters side by side from the border inwards [Flores2018, section 6.2.1], each a run that ends
/// shortly before its start. A perimeter is deposited where nearly its whole bead has room. If a solid fill
/// has as many perimeters as have room, beads along the medial axis fill what is too narrow for them.
/// @throws InvalidInput if the spacing is not positive, or so small that there would be more than 100000
std::vector<FillPath> perimeters(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
