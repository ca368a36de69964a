// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <utility>

#include "lamina/planning/hooks/hooks.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "planning/cooling/parking.hpp"
#include "planning/hooks/layer_places.hpp"

namespace lamina {

void addPauses(Toolpath& toolpath, const PauseSettings& settings, const CoolingSettings& parking,
               const HookSite& site) {
  if (settings.at_layers.empty() && settings.at_heights_mm.empty()) return;
  const LayerPlaces places(toolpath, site);
  std::set<std::size_t> paused;
  for (const double layer : settings.at_layers)
    paused.insert(places.layer(static_cast<std::size_t>(layer), "pause.at_layers"));
  for (const double height_mm : settings.at_heights_mm)
    paused.insert(places.above(height_mm, "pause.at_heights_mm"));
  ParkingGround ground{depositionBox(toolpath), layerNormal(toolpath)};
  const std::vector<double> heights = heightsUpTo(toolpath, ground.up);
  for (const std::size_t index : paused) {
    ToolpathLayer& layer = toolpath.layers[index];
    const std::size_t bead = firstBead(layer);
    ground.highest_mm = heights[index];
    Path path = parkedWait(layer.paths[bead], 0, travelFeed(layer), ground, parking);
    path.events.front().event.emplace<OperatorPause>();
    layer.paths.insert(layer.paths.begin() + static_cast<std::ptrdiff_t>(bead), std::move(path));
  }
}

}  // namespace lamina
