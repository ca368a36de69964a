// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/rewrite_report.hpp"

namespace lamina {

bool standsOnEdge(const RewriteReport& report) {
  constexpr double kNarrow = 0.1;
  if (report.footprint.isEmpty()) return false;
  const Point3 base = report.footprint.size();
  const Point3 part = report.part.size();
  return base.x() < kNarrow * part.x() || base.y() < kNarrow * part.y();
}

bool isToolAxisOffNormal(const RewriteReport& report) {
  return report.tool_axis_off_normal_deg > kToolAxisToleranceDeg;
}

}  // namespace lamina
