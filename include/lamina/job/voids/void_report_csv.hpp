// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// The voids of each layer as CSV: a line of names, then one line per layer with layer, z_mm, area_mm2,
/// deposited_mm2, uncovered_mm2, overfill_mm2, runs, voids, and the number of voids of each class.
std::string voidCsv(const std::vector<LayerVoids>& layers);

/// Writes the table whole or not at all.
/// @throws FileError
void writeVoidCsv(const std::string& path, const std::vector<LayerVoids>& layers);

}  // namespace lamina
