// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/rewrite_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

[[noreturn]] void refuse(const std::string& field, double value, const std::string& bounds) {
  throw InvalidConfig(field + " is " + numberText(value) + "; must be " + bounds);
}

void requireWithin(const std::string& field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    refuse(field, value, "in [" + numberText(low) + ", " + numberText(high) + "]");
}

}  // namespace

void validate(const RewriteSettings& settings) {
  constexpr double kFurthest = 1e6;  // mm
  if (settings.decimals) requireWithin("decimals", *settings.decimals, 0.0, 6.0);
  if (settings.layer_height_mm && !(*settings.layer_height_mm > 0.0 && *settings.layer_height_mm <= 100.0))
    refuse("layer_height_mm", *settings.layer_height_mm, "in (0, 100]");
  for (int axis = 0; axis < 3; ++axis) {
    requireWithin("offset_mm", settings.offset_mm[axis], -kFurthest, kFurthest);
    if (settings.final_position_mm)
      requireWithin("final_position_mm", (*settings.final_position_mm)[axis], -kFurthest, kFurthest);
    if (settings.limits_mm && !(settings.limits_mm->low[axis] < settings.limits_mm->high[axis]))
      refuse("limits_mm", settings.limits_mm->low[axis],
             "below " + numberText(settings.limits_mm->high[axis]));
  }
  if (settings.table_position_mm) {
    for (int axis = 0; axis < 2; ++axis)
      requireWithin("table_position_mm", (*settings.table_position_mm)[axis], -kFurthest, kFurthest);
    if (settings.offset_mm.head<2>() != Point2::Zero())
      throw InvalidConfig("table_position_mm and offset_mm both say where the part comes; expected one");
  }
  if (settings.tool_axis && !(settings.tool_axis->norm() > 1e-9 && settings.tool_axis->allFinite()))
    refuse("the length of tool axis", settings.tool_axis->norm(), "more than 1e-9");
  requireWithin("final_feed_mm_min", settings.final_feed_mm_min, 1.0, 1e6);
  requireWithin("chord_tolerance_mm", settings.chord_tolerance_mm, 1e-4, 10.0);
}

int decimalsOf(const RewriteSettings& settings) {
  return settings.decimals.value_or(settings.mode == RewriteMode::Listing ? 2 : 3);
}

}  // namespace lamina
