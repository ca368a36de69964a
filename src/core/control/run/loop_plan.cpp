// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The rung of a print under the loop that plans the layers left anew.
#include <algorithm>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/control/replanned_toolpath.hpp"
#include "lamina/control/run/loop_run.hpp"

namespace lamina {

bool LoopRun::follow(const std::string& toolpath_id) {
  passAll();
  if (!plan_ || plan_->part.toolpath_id != toolpath_id) return false;
  waiting_.clear();
  missed_.clear();
  part_ = std::move(plan_->part);
  progress_ = LayerProgress(part_.toolpath, settings_.following);
  loop_ = std::move(plan_loop_);
  atlas_ = CellAtlas(settings_.sight.window_layers);
  below_.clear();
  below_layer_ = 0;
  if (isCorrecting()) status_ = afterReplan(status_, plan_->raised_mm);
  mean_shift_mm_ = last_amount_ = 0.0;
  short_mm_ = plan_->short_mm;
  layer_alarms_.clear();
  trim_refused_.reset();
  plan_.reset();
  plan_loop_.reset();
  taught_.abandon();
  beginLayer(0);
  return true;
}

bool LoopRun::refusePlan(const std::string& toolpath_id, const std::string& reason) {
  if (!plan_ || plan_->part.toolpath_id != toolpath_id) return false;
  take({status_,
        {{LoopAlarm::Saturated, LoopReaction::Warn,
          "layer " + std::to_string(plan_->layer) + " is deposited as before, not by plan " + toolpath_id +
              ": " + reason}}});
  const bool is_next = layer_ == plan_->layer;
  plan_.reset();
  plan_loop_.reset();
  if (is_next) publishMap();
  return true;
}

/// Why amounts alone will not do; empty where they will.
std::string LoopRun::reasonToPlan(const LayerFigures& figures) const {
  for (const RaisedAlarm& alarm : layer_alarms_)
    if (alarm.alarm == LoopAlarm::Saturated && alarm.reaction == LoopReaction::Replan) return alarm.reason;
  if (figures.layer < static_cast<std::size_t>(settings_.loop.first_layers)) return {};
  PartUnderWay part{{}, figures.mean_error_mm, figures.gain_mean};
  for (std::size_t i = *layer_ + 1; i < part_.toolpath.layers.size(); ++i)
    part.heights_left_mm.push_back(part_.toolpath.layers[i].height_mm);
  const double authority = std::min(settings_.loop.greatest_amount, settings_.loop.layer_volume);
  if (part.heights_left_mm.empty() || !needsReplanning(part, figures.height_mm, authority)) return {};
  return "the layers are " + numberText(figures.mean_error_mm) + " mm too low in the mean, and the top " +
         "would end " + numberText(expectedTopError(part, authority)) +
         " mm too low; expected a layer and half a layer at most, of " + numberText(figures.height_mm) +
         " mm";
}

/// A plan holds for the layer that comes next alone.
void LoopRun::planAnew(const LayerFigures& figures) {
  plan_.reset();
  plan_loop_.reset();
  const bool plans = settings_.loop.replan == Replanning::Scale || settings_.loop.replan == Replanning::Add;
  const bool is_free = settings_.loop.process == LoopProcess::Free;
  if (!plans || !is_free || status_.state != LoopState::Active || !figures.is_measured) return;
  const std::string reason = reasonToPlan(figures);
  if (reason.empty()) return;
  try {
    offerPlan(figures, reason);
  } catch (const InvalidInput& error) {
    take({status_, {{LoopAlarm::Saturated, LoopReaction::Hold, reason + "; no plan: " + error.what()}}});
  }
}

void LoopRun::offerPlan(const LayerFigures& figures, const std::string& reason) {
  const LayersLeft left{*layer_ + 1, figures.mean_error_mm};
  PartUnderWay under_way = partUnderWay(part_.toolpath, left, figures.gain_mean);
  under_way.error_mm += short_mm_;
  const auto heights = newHeights(under_way, settings_.loop.replan);
  if (!heights)
    throw InvalidInput("no number of layers of 0.7 to 1.3 of their heights comes to the planned top");
  PrintPlan plan;
  plan.part = {{}, part_.bed_from_part, replannedToolpath(part_.toolpath, left, *heights), part_.machine};
  plan.layer = left.first;
  plan.part.toolpath_id = replannedId(plan.part.toolpath, plan.layer, part_.toolpath_id);
  plan.raised_mm = -figures.mean_error_mm;
  plan.flow = heights->flow;
  plan.short_mm = short_mm_ + part_.toolpath.layers.back().z_mm - plan.part.toolpath.layers.back().z_mm;
  plan.reason = reason;
  plan_loop_ = *loop_;
  plan_loop_->replan(plan.raised_mm, plan.flow);
  const bool is_told = std::any_of(layer_alarms_.begin(), layer_alarms_.end(), [](const RaisedAlarm& alarm) {
    return alarm.alarm == LoopAlarm::Saturated;
  });
  if (!is_told) take({status_, {{LoopAlarm::Saturated, LoopReaction::Replan, reason}}});
  plan_ = plan;
  news_.plans.push_back(std::move(plan));
}

}  // namespace lamina
