// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Layers that would have to be there and are not, without paths [frame of the program], ascending: between
/// layers as many as are as high as the one above them, and above the last one as many as that up to the top
/// of the part. A rest of half a layer is none. Whether the part has
/// material there is not looked at.
/// @param part_height_mm  of its box, from the bottom of the first layer
/// @throws InvalidInput if there would be more than a million
std::vector<ToolpathLayer> layersBetween(const Toolpath& program, double part_height_mm);

}  // namespace lamina
