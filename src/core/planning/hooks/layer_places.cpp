// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/hooks/layer_places.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "planning/same_height.hpp"
#include "toolpath/part_begin.hpp"

namespace lamina {

std::size_t firstBead(const ToolpathLayer& layer) {
  const auto bead = std::find_if(layer.paths.begin(), layer.paths.end(),
                                 [](const Path& path) { return path.role != PathRole::Travel; });
  return static_cast<std::size_t>(bead - layer.paths.begin());
}

LayerPlaces::LayerPlaces(const Toolpath& toolpath, const HookSite& site)
    : toolpath_(toolpath),
      rise_mm_((site.bed_from_part.linear() * layerNormal(toolpath)).dot(site.bed_from_part.translation())) {}

std::size_t LayerPlaces::layer(std::size_t number, const std::string& what) const {
  for (std::size_t i = number; i < toolpath_.layers.size(); ++i)
    if (firstBead(toolpath_.layers[i]) < toolpath_.layers[i].paths.size()) return i;
  throw InvalidConfig(what + " asks for layer " + std::to_string(number) + "; the part has " +
                      std::to_string(toolpath_.layers.size()) + ", counted from 0");
}

std::vector<std::size_t> LayerPlaces::above(double height_mm, const std::string& what) const {
  std::vector<std::size_t> found;
  bool is_sought = true;  // in this part
  for (std::size_t i = 0; i < toolpath_.layers.size(); ++i) {
    const ToolpathLayer& layer = toolpath_.layers[i];
    is_sought = is_sought || beginsPart(toolpath_.layers, i);
    const bool lays = firstBead(layer) < layer.paths.size();
    if (!is_sought || !lays || topOf(i) - layer.height_mm < height_mm - kSameHeight) continue;
    found.push_back(i);
    is_sought = false;
  }
  if (!found.empty()) return found;
  throw InvalidConfig(what + " asks for a height of " + numberText(height_mm) +
                      " mm; no layer begins at or above it");
}

}  // namespace lamina
