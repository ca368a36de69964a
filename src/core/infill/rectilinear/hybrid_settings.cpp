// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/rectilinear/hybrid_settings.hpp"

namespace lamina {
namespace {

void describeAdaptation(SettingsSchema& schema, HybridSettings& settings) {
  schema.number("hybrid.add_above", settings.add_above, {0.0, 10.0},
                "A curve is added where the outermost line is farther from the perimeter, in spacings.");
  schema.number("hybrid.delete_below", settings.delete_below, {0.0, 10.0},
                "The outermost line is replaced by a curve where it is nearer, in spacings.");
  schema.number("hybrid.approach", settings.approach, Bounds::above(0.0, 10.0),
                "Distance of that curve, and of line ends, from the perimeter, in spacings.");
  schema.integer("hybrid.curve_points", settings.curve_points, {2, 10000}, "Points of that curve.");
  schema.number("hybrid.end_margin", settings.end_margin, {0.0, 10.0},
                "By how much that curve ends short of the line beside it, in spacings.");
}

}  // namespace

void describe(SettingsSchema& schema, HybridSettings& settings) {
  schema.choice("hybrid.lines", settings.lines,
                {{"fitted", HybridLines::Fitted}, {"metal", HybridLines::Metal}},
                "Lines inside the perimeter: fitted to the area, or on a grid and adapted, for metal.");
  schema.renamedChoice("hybrid.lines", "documented", "metal");
  schema.choice("hybrid.longitudinal", settings.longitudinal,
                {{"two_pass", LongitudinalAdaptation::TwoPass}, {"clipped", LongitudinalAdaptation::Clipped}},
                "How ends of lines on the grid are brought to their distance from the perimeter.");
  schema.number("hybrid.grid_x_mm", settings.grid_x_mm, {-10000.0, 10000.0},
                "Where a node of the grid lies.");
  schema.number("hybrid.grid_y_mm", settings.grid_y_mm, {-10000.0, 10000.0},
                "Where a node of the grid lies.");
  schema.number("hybrid.perimeter_step", settings.perimeter_step, {0.01, 10.0},
                "Distance of the perimeter points that line ends are moved towards, in spacings.");
  describeAdaptation(schema, settings);
  schema.integer("hybrid.extra_perimeter_every", settings.extra_perimeter_every, {0, 1000000},
                 "Every so many layers there is one perimeter more; 0 for none.");
}

}  // namespace lamina
