// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/refill.hpp"

#include <string>

#include "infill/variable_width/solid_beads.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

void requireNotNegative(const char* what, double value) {
  if (!(value >= 0.0))
    throw InvalidInput(std::string(what) + " of refilled voids is " + numberText(value) +
                       "; must not be negative");
}

}  // namespace

std::vector<FillPath> refill(const LayerVoids& layer, const RefillSettings& settings) {
  requireNotNegative("least area", settings.least_area);
  requireNotNegative("least width", settings.least_width);
  if (!(layer.pitch_mm > 0.0)) return {};  // nothing is deposited, hence there is no bead to go by
  const double least_mm2 = settings.least_area * layer.pitch_mm * layer.pitch_mm;
  Regions filled;
  for (const Void& each : layer.voids)
    if (each.area_mm2 >= least_mm2) filled.push_back(each.outline);
  MedialBeadSettings beads;
  beads.pitch_mm = layer.pitch_mm;
  beads.least_width = settings.least_width;
  // The outline of a void is as coarse as the rows it was found on, and may touch itself.
  return solidBeads(unite(outlines(filled)), beads, settings.least_area);
}

}  // namespace lamina
