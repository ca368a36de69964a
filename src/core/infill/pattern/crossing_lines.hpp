// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Straight lines in several directions in each layer, with the same total density as the lines of a zigzag.
/// Lines that end beside each other are joined along the border. A solid fill is a zigzag.
///
/// `gridFill`: two directions at right angles, each at twice the spacing.
/// `trianglesFill`: three directions 60 degrees apart, each at three times the spacing, that meet in points.
/// `cubicFill`: as `trianglesFill`, but shifted from layer to layer so that each line lies in one of three
/// families of planes at right angles to each other. The cells are cubes that stand on a corner.
std::vector<FillPath> gridFill(const Regions& regions, const InfillRequest& request);
std::vector<FillPath> trianglesFill(const Regions& regions, const InfillRequest& request);
std::vector<FillPath> cubicFill(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
