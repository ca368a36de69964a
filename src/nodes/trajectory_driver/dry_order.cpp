// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dry_order.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/job_override.hpp"
#include "lamina/toolpath/tool_point.hpp"

namespace lamina {
namespace {

constexpr double kLeastDrySpeed = 0.01;  // of the planned speeds

DryPlace placeOf(const std::string& name) {
  if (name.empty()) return DryPlace::None;
  if (name == "air") return DryPlace::Air;
  if (name == "lift") return DryPlace::Lift;
  if (name == "point") return DryPlace::Point;
  throw InvalidInput("dry is '" + name +
                     "'; expected air, lift or point, or nothing for a job with its process");
}

}  // namespace

void describe(SettingsSchema& schema, DrySettings& settings) {
  schema.number("dry.lift_mm", settings.lift_mm, {0.0, 1e3},
                "How far above its toolpath, along the tool axis, a job is run dry by lift.");
  schema.numbers(
      "dry.pointer_mm", settings.pointer_mm, 3,
      "Tip of the pointer that is on the toolpath where a job is run dry by point, in the nozzle's "
      "frame, whose z goes on from the tip; empty without one.");
}

DryOrder dryOrderOf(const lamina_msgs::DriveToolpathGoal& goal) {
  const DryPlace place = placeOf(goal.dry);
  if (place == DryPlace::None && goal.speed != 0.0)
    throw InvalidInput("speed is " + numberText(goal.speed) +
                       ", of a job with its process; expected 0, or a dry run (change_job changes the feed)");
  const double speed = goal.speed == 0.0 ? 1.0 : goal.speed;
  const std::string refusal =
      overrideRefusal(OverrideKind::Feed, speed, {kLeastDrySpeed, boundsOf(OverrideKind::Feed).most});
  if (!refusal.empty()) throw InvalidInput("speed of a dry run: " + refusal);
  return {place, speed};
}

Toolpath drivenAs(const DryOrder& order, Toolpath toolpath, const DrySettings& settings) {
  if (order.place == DryPlace::Lift) return withToolPoint(std::move(toolpath), {0.0, 0.0, settings.lift_mm});
  if (order.place != DryPlace::Point) return toolpath;
  if (settings.pointer_mm.empty())
    throw InvalidInput("dry.pointer_mm is not set; expected the pointer's tip in the nozzle's frame");
  return withToolPoint(std::move(toolpath),
                       {settings.pointer_mm[0], settings.pointer_mm[1], settings.pointer_mm[2]});
}

}  // namespace lamina
