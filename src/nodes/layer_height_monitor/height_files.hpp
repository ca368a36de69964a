// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/monitoring/height_monitor.hpp"

namespace lamina {

/// Writes height_map.png, deviation.png, height_map.bt and layer_heights.csv into a folder, which is made if
/// need be. Each file appears whole or not at all.
/// @throws FileError
void saveHeights(const std::string& folder, const HeightMonitor& monitor,
                 const std::vector<LayerHeightReport>& layers);

}  // namespace lamina
