// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline_messages.hpp"

#include "conversions.hpp"

namespace lamina {

lamina_msgs::InclineSummary toMessage(const RewriteReport& report) {
  lamina_msgs::InclineSummary summary;
  summary.slicer = report.slicer;
  summary.lines = report.lines;
  summary.layers = static_cast<std::uint32_t>(report.layers);
  summary.motions = report.motions;
  summary.depositions = report.depositions;
  summary.arcs_made_chords = report.arcs;
  summary.homings_annulled = static_cast<std::uint32_t>(report.homings_annulled);
  summary.build_aids_dropped = report.aids_dropped;
  summary.layer_height = toMetres(report.layer_height_mm);
  summary.shift.x = toMetres(report.shift.x());
  summary.shift.y = toMetres(report.shift.y());
  summary.shift.z = toMetres(report.shift.z());
  summary.part_low = toMessage(report.part.low);
  summary.part_high = toMessage(report.part.high);
  summary.stands_on_edge = static_cast<std::uint8_t>(standsOnEdge(report));
  return summary;
}

}  // namespace lamina
