// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/rewrite_report.hpp"

#include "base/decimals.hpp"

namespace lamina {

bool standsOnEdge(const RewriteReport& report) {
  constexpr double kNarrow = 0.1;
  if (report.footprint.isEmpty()) return false;
  const Point3 base = report.footprint.size();
  const Point3 part = report.part.size();
  return base.x() < kNarrow * part.x() || base.y() < kNarrow * part.y();
}

bool beginsInAir(const RewriteReport& report) {
  constexpr double kMostLayers = 2.0;
  return report.first_layer_gap_mm > kMostLayers * report.layer_height_mm;
}

std::string noticeOnFirstLayer(const RewriteReport& report) {
  if (!beginsInAir(report)) return "";
  constexpr int kShownDigits = 3;
  return "the first layer begins " + significantText(report.first_layer_gap_mm, kShownDigits) +
         " mm above the bed, and nothing is below it; expected a part that stands on an edge or a face where "
         "its layers begin, or one on supports (lamina slice with slicing.plane.angle_deg lays them)";
}

bool isToolAxisOffNormal(const RewriteReport& report) {
  return report.tool_axis_off_normal_deg > kToolAxisToleranceDeg;
}

}  // namespace lamina
