// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/failing_layer.hpp"

#include <cstdio>

namespace lamina {

std::string layerPlace(std::size_t layer, double top_mm) {
  char text[80];
  std::snprintf(text, sizeof text, "layer %zu at %.6g mm", layer, top_mm);
  return text;
}

std::string islandPlace(std::size_t layer, double top_mm, std::size_t island) {
  return layerPlace(layer, top_mm) + ", island " + std::to_string(island);
}

}  // namespace lamina
