// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <utility>

#include "lamina/planning/hooks/hooks.hpp"
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
    for (const std::size_t layer : places.above(height_mm, "pause.at_heights_mm")) paused.insert(layer);
  const std::vector<ParkingGround> grounds = parkingGrounds(toolpath);
  for (const std::size_t index : paused) {
    ToolpathLayer& layer = toolpath.layers[index];
    const std::size_t bead = firstBead(layer);
    const ParkingGround& ground = grounds[index];
    Path path = parkedWait(layer.paths[bead], 0, ground.travel_mm_s, ground, parking);
    path.events.front().event.emplace<OperatorPause>();
    layer.paths.insert(layer.paths.begin() + static_cast<std::ptrdiff_t>(bead), std::move(path));
  }
}

}  // namespace lamina
