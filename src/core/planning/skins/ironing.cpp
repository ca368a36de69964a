// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/ironing.hpp"

#include "infill/rectilinear/zigzag.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

bool laysInOneSense(const SkinSettings& settings, PathRole role) {
  return settings.is_monotonic && role == PathRole::TopSkin &&
         infillStrategy(settings.strategy).advance == LineAdvance::OneSense;
}

std::vector<FillPath> ironingLines(const Regions& seen, const IroningSettings& settings, double angle_rad) {
  InfillRequest request;
  request.spacing_mm = request.pitch_mm = settings.spacing_mm;
  request.angle_rad = angle_rad;
  std::vector<FillPath> lines = rasterRuns(offset(unite(outlines(seen)), -settings.inset_mm), request);
  for (FillPath& line : lines) line.role = PathRole::Ironing;
  return lines;
}

Bead ironingBead(const IroningSettings& settings, double layer_height_mm) {
  return beadOfArea(settings.flow * settings.spacing_mm * layer_height_mm, layer_height_mm);
}

}  // namespace lamina
