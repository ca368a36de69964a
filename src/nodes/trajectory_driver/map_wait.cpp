// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_wait.hpp"

#include <cstdio>

#include "lamina/control/replanned_toolpath.hpp"

namespace lamina {
namespace {

std::string nameOf(std::size_t layer) { return "layer " + std::to_string(layer); }

std::string seconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", time_s);
  return text;
}

}  // namespace

MapWait::MapWait(TrajectoryFeeder& feeder, ChunkCorrection& correction, double wait_s)
    : feeder_(feeder), correction_(correction), wait_s_(wait_s) {}

bool MapWait::look(double now_s, Motion motion) {
  if (!feeder_.isHeld()) {
    holdAtNext(now_s);
    return false;
  }
  if (motion == Motion::Moves)
    rests_at_.reset();
  else if (!rests_at_)
    rests_at_ = now_s;
  if (plan_) return false;
  if (!correction_.isKnown(awaited_)) {
    if (!rests_at_ || now_s - *rests_at_ < wait_s_) return false;
    notice_ = "the map of " + nameOf(awaited_) + " has not come within " + seconds(wait_s_) +
              ": it is driven by its coasting map, or as planned where none is there (6116)";
    correction_.giveUp(awaited_, now_s - *rests_at_);
  }
  enter(now_s);
  return true;
}

void MapWait::enter(double now_s) {
  feeder_.release(now_s);
  passLayer();
  rests_at_.reset();
}

/// A plan that begins with a layer that was entered comes too late.
void MapWait::passLayer() {
  ++awaited_;
  plan_.reset();
}

void MapWait::holdAtNext(double now_s) {
  if (feeder_.state() != TrajectoryFeederState::Running) return;
  for (; awaited_ < correction_.layers(); passLayer()) {
    if (correction_.isKnown(awaited_)) continue;
    if (feeder_.holdAtLayer(awaited_, now_s)) return;
    if (!std::exchange(has_passed_, true))
      notice_ = "the motion cannot stop in front of " + nameOf(awaited_) +
                ": its map is not waited for, nor are those of others like it";
  }
}

void MapWait::resume(double now_s) {
  feeder_.resume(now_s);
  rests_at_.reset();
  if (!feeder_.isHeld()) holdAtNext(now_s);
}

std::string MapWait::offer(const lamina_msgs::ToolpathConstPtr& plan) {
  const auto held = feeder_.isHeld() ? std::optional(awaited_) : std::nullopt;
  std::string refusal = refusalOfPlan(plan->id, correction_.toolpathId(), held);
  if (refusal.empty())
    plan_ = plan;
  else if (isPlanOf(plan->id, correction_.toolpathId()))
    correction_.refusePlan(plan->id, refusal);
  return refusal;
}

void MapWait::refuse(const std::string& plan_id, const std::string& reason) {
  correction_.refusePlan(plan_id, reason);
  if (!plan_ || plan_->id != plan_id) return;
  plan_.reset();
  rests_at_.reset();
}

}  // namespace lamina
