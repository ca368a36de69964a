// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/part_placement.hpp"

#include <string>

#include "gcode_rewrite/decimal_number.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-6;  // mm: below what programs resolve

std::string shown(double value_mm) {
  std::string text;
  appendFixed(text, value_mm, 3);
  return text + " mm";
}

std::string hint(const Extremes& reached, const Box3& limits, Eigen::Index axis, double shift) {
  const double low = reached.box.low[axis] + shift;
  const double high = reached.box.high[axis] + shift;
  const double room = limits.high[axis] - limits.low[axis];
  if (high - low > room) return "the program spans " + shown(high - low) + " there and cannot fit";
  const double move = low < limits.low[axis] ? limits.low[axis] - low : limits.high[axis] - high;
  return "it would fit if it were moved by " + shown(move);
}

void requirePartWithin(const Extremes& reached, const Point3& shift, const Box3& limits) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    const double low = reached.box.low[axis] + shift[axis];
    const double high = reached.box.high[axis] + shift[axis];
    const bool is_low = low < limits.low[axis] - kRounding;
    if (!is_low && !(high > limits.high[axis] + kRounding)) continue;
    throw Unreachable("line " + std::to_string(is_low ? reached.low_line[index] : reached.high_line[index]) +
                      ": the nozzle would be at " + "xyz"[axis] + " = " + shown(is_low ? low : high) +
                      "; must be in [" + shown(limits.low[axis]) + ", " + shown(limits.high[axis]) + "]; " +
                      hint(reached, limits, axis, shift[axis]));
  }
}

void requireAboveBed(const Extremes& deposited, double shift_mm, const std::string& what) {
  if (deposited.box.isEmpty() || deposited.box.low.z() + shift_mm >= -kRounding) return;
  throw Unreachable("line " + std::to_string(deposited.low_line[2]) + ": " + what +
                    " would be deposited at z = " + shown(deposited.box.low.z() + shift_mm) +
                    ", below the bed; must be 0 mm or more");
}

void requireFinalWithin(const Point3& position, const Box3& limits) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!(position[axis] >= limits.low[axis] && position[axis] <= limits.high[axis]))
      throw Unreachable(std::string("the final position is ") + "xyz"[axis] + " = " + shown(position[axis]) +
                        "; must be in [" + shown(limits.low[axis]) + ", " + shown(limits.high[axis]) + "]");
}

}  // namespace

Point3 shiftOf(const Survey& survey, const RewriteSettings& settings) {
  Point3 shift = settings.offset_mm;
  const Box3& part = survey.totals.part.box;
  if (settings.table_position_mm) shift.head<2>() = *settings.table_position_mm - part.centre().head<2>();
  if (settings.lift == Lift::None) return shift;
  const auto height = settings.layer_height_mm ? settings.layer_height_mm : survey.layer_height_mm;
  if (!height)
    throw InvalidProgram(
        "the program does not report its layer height, at which the lowest deposition is put; expected it to "
        "be "
        "given (layer_height_mm)");
  shift.z() += *height - part.low.z();
  return shift;
}

void requireReachable(const Survey& survey, const Point3& shift, const RewriteSettings& settings) {
  const SurveyTotals& totals = survey.totals;
  requireAboveBed(totals.part, shift.z(), "the part");
  if (settings.build_aids == BuildAids::Kept)
    requireAboveBed(
        totals.aids, shift.z(),
        "skirt, brim, raft or support lies on the slicer's bed, not on the machine's; slice without, "
        "or drop it. It");
  if (!settings.limits_mm) return;
  if (settings.final_position_mm) requireFinalWithin(*settings.final_position_mm, *settings.limits_mm);
  // Where the nozzle goes if aids are dropped is known only when they are.
  const bool is_known = settings.build_aids == BuildAids::Kept;
  requirePartWithin(is_known ? totals.nozzle : totals.part, shift, *settings.limits_mm);
}

void requireWithinLimits(const Extremes& nozzle, const RewriteSettings& settings) {
  if (settings.limits_mm) requirePartWithin(nozzle, Point3::Zero(), *settings.limits_mm);
}

}  // namespace lamina
