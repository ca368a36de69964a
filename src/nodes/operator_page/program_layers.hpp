// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// All layers of a program, at most a million points of it. Layers are those of the slicer's comments;
/// without comments, a layer begins at each new height of deposition.
/// @param is_unwanted  ends the call when true
/// @throws Error if the program cannot be read, has more than 256 MB, or is not wanted any more
std::vector<LayerPreview> layersOf(const std::string& program, const std::atomic<bool>& is_unwanted);

}  // namespace lamina
