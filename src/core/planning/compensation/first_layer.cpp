// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/compensation/first_layer.hpp"

#include <utility>

#include "planning/run_path.hpp"

namespace lamina {

PlanSettings onBed(PlanSettings settings) {
  const FirstLayerSettings& first = settings.first_layer;
  for (double* each : {&settings.bead.width_mm, &settings.bead.pitch_mm, &settings.infill.bead_width_mm,
                       &settings.skins.bead_width_mm, &settings.supports.bead_width_mm})
    *each *= first.width_factor;
  FeedSettings& feed = settings.feed;
  for (double* each : {&feed.outer_wall_mm_s, &feed.inner_wall_mm_s, &feed.infill_mm_s, &feed.skin_mm_s,
                       &feed.top_skin_mm_s, &feed.bridge_mm_s, &feed.skirt_mm_s, &feed.support_mm_s,
                       &feed.support_interface_mm_s, &feed.first_layer_mm_s})
    *each *= first.feed_factor;
  return settings;
}

void scaleFlow(ToolpathLayer& layer, double factor) {
  if (factor == 1.0) return;
  for (Path& path : layer.paths) path = withFlow(std::move(path), factor);
}

}  // namespace lamina
