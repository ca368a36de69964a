// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/loop_plan.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/replanned_toolpath.hpp"

namespace lamina {

std::string reasonToPlan(const Toolpath& toolpath, const LayerFigures& figures,
                         const std::vector<RaisedAlarm>& raised, const LoopSettings& settings) {
  for (const RaisedAlarm& alarm : raised)
    if (alarm.alarm == LoopAlarm::Saturated && alarm.reaction == LoopReaction::Replan) return alarm.reason;
  if (figures.layer < static_cast<std::size_t>(settings.first_layers)) return {};
  PartUnderWay part{{}, figures.mean_error_mm, figures.gain_mean};
  for (std::size_t i = figures.layer + 1; i < toolpath.layers.size(); ++i)
    part.heights_left_mm.push_back(toolpath.layers[i].height_mm);
  const LayerAuthority authority{std::max(settings.least_amount, -settings.layer_volume),
                                 std::min(settings.greatest_amount, settings.layer_volume)};
  if (part.heights_left_mm.empty() || !needsReplanning(part, figures.height_mm, authority)) return {};
  return "the layers are " + numberText(figures.mean_error_mm) + " mm too low in the mean, and the top " +
         "would end " + numberText(expectedTopError(part, authority)) +
         " mm too low; expected a layer and half a layer at most, of " + numberText(figures.height_mm) +
         " mm";
}

PrintPlan planOfLayersLeft(const PlacedPart& part, const LayerFigures& figures, double short_mm,
                           const LoopSettings& settings) {
  const LayersLeft left{figures.layer + 1, figures.mean_error_mm};
  PartUnderWay under_way = partUnderWay(part.toolpath, left, figures.gain_mean);
  under_way.error_mm += short_mm;
  const auto heights = newHeights(under_way, settings.replan);
  if (!heights)
    throw InvalidInput("no number of layers of 0.7 to 1.3 of their heights comes to the planned top");
  PrintPlan plan;
  plan.part = {{}, part.bed_from_part, replannedToolpath(part.toolpath, left, *heights), part.machine};
  plan.layer = left.first;
  plan.part.toolpath_id = replannedId(plan.part.toolpath, plan.layer, part.toolpath_id);
  plan.raised_mm = -figures.mean_error_mm;
  plan.flow = heights->flow;
  plan.short_mm = short_mm + part.toolpath.layers.back().z_mm - plan.part.toolpath.layers.back().z_mm;
  return plan;
}

}  // namespace lamina
