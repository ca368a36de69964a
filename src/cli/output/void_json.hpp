// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lamina/voids/beads/void_map.hpp"

namespace lamina::cli {

/// A layer's account: areas, runs, and each void with class, area and outline [mm].
nlohmann::ordered_json layerToJson(const LayerVoids& layer, std::size_t index);

/// Writes the accounts of all layers as one JSON object with the list "layers", whole or not at all.
/// @throws FileError
void writeVoidJson(const std::string& path, const std::vector<LayerVoids>& layers);

}  // namespace lamina::cli
