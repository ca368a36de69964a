// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/solid_beads.hpp"

#include <utility>

#include "infill/contour/contour_tree.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

FillPath runOf(ContourLoop loop) {
  FillPath run;
  run.role = PathRole::GapFill;
  run.is_closed = true;
  run.points = std::move(loop.points);
  run.width_mm = std::move(loop.width_mm);
  return run;
}

std::vector<FillPath> loopsAndBeads(const Region& region, const MedialBeadSettings& settings,
                                    double least_rest) {
  InfillRequest request;
  request.pitch_mm = settings.pitch_mm;
  request.spacing_mm = settings.pitch_mm;
  OpenContourTree contours = openContourTree(region, request);
  std::vector<FillPath> runs;
  for (ContourLoop& loop : contours.tree.loops) runs.push_back(runOf(std::move(loop)));
  const double least_mm2 = least_rest * settings.pitch_mm * settings.pitch_mm;
  for (const NarrowRest& rest : contours.rests)
    if (area({rest.area}) >= least_mm2) appendTo(runs, medialBeads({rest.area}, settings));
  return runs;
}

}  // namespace

std::vector<FillPath> solidBeads(const Regions& regions, const MedialBeadSettings& settings,
                                 double least_rest) {
  std::vector<FillPath> runs;
  for (const Region& region : regions) {
    const bool is_wide = !offset({region}, -settings.widest_bead * settings.pitch_mm).empty();
    appendTo(runs, is_wide ? loopsAndBeads(region, settings, least_rest) : medialBeads({region}, settings));
  }
  return runs;
}

}  // namespace lamina
