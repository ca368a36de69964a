// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/contour/perimeters_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, PerimetersSettings& settings) {
  schema.integer("perimeters.count", settings.count, {0, 100000},
                 "Number of perimeters; 0 for as many as fit, and beads in the narrow rest.");
  schema.choice("perimeters.offset", settings.offset,
                {{"robust", PerimeterOffset::Robust}, {"normals", PerimeterOffset::Normals}},
                "How a perimeter follows from the one outside: as an area, or point by point.");
  schema.choice("perimeters.order", settings.order,
                {{"outside_in", PerimeterOrder::OutsideIn},
                 {"inside_out", PerimeterOrder::InsideOut},
                 {"alternating", PerimeterOrder::Alternating}},
                "Order of the perimeters; alternating changes it from layer to layer.");
  schema.number("perimeters.first_inset", settings.first_inset, {0.0, 10.0},
                "Distance of the outermost perimeter's centre line from the border, in pitches.");
  schema.number("perimeters.end_gap", settings.end_gap, {0.0, 10.0},
                "By how much a perimeter ends short of its start, in pitches; 0 closes it.");
  schema.choice("perimeters.seam", settings.seam,
                {{"progressive", PerimeterSeam::Progressive}, {"random", PerimeterSeam::Random}},
                "Where perimeters start: farther along in each layer, or at random.");
  schema.number("perimeters.seam_step", settings.seam_step, {0.0, 100000.0},
                "By how much the progressive start advances, in pitches.");
  schema.integer("perimeters.seed", settings.seed, {0, 2147483647}, "Seed of the random starts.");
}

}  // namespace lamina
