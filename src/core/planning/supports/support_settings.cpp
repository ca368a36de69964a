// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/supports/support_settings.hpp"

namespace lamina {
namespace {

constexpr Bounds kGap{0.0, 100.0};
constexpr Bounds kDensity = Bounds::above(0.0, 1.0);
constexpr Bounds kTool{-1, 255};

void describeBranches(SettingsSchema& schema, SupportSettings& supports) {
  schema.number("supports.tip_mm", supports.tip_mm, {0.01, 100.0},
                "Diameter of what holds up a hanging point, and of the tips of branches.");
  schema.number("supports.tip_spacing_mm", supports.tip_spacing_mm, {0.1, 100.0},
                "Distance of neighbouring tips of branches.");
  schema.number("supports.branch_angle_deg", supports.branch_angle_deg, {0.0, 80.0},
                "Most lean of a branch from the vertical.");
  schema.number("supports.branch_taper_deg", supports.branch_taper_deg, {0.0, 45.0},
                "Angle by which each side of a branch widens towards its foot.");
  schema.number("supports.branch_mm", supports.branch_mm, {0.1, 100.0}, "Greatest diameter of a branch.");
}

void describeSizes(SettingsSchema& schema, SupportSettings& supports) {
  schema.number("supports.top_gap_mm", supports.top_gap_mm, kGap,
                "Distance between a support and what it holds up; 0 touches.");
  schema.number("supports.bottom_gap_mm", supports.bottom_gap_mm, kGap,
                "Least distance between a support and the part it stands on.");
  schema.number("supports.side_gap_mm", supports.side_gap_mm, kGap,
                "Distance between supports and the part beside them.");
  schema.integer("supports.interface_layers", supports.interface_layers, {0, 100},
                 "Number of dense layers where a support meets the part.");
  schema.number("supports.interface_density", supports.interface_density, kDensity,
                "Part of these layers that is filled.");
  schema.number("supports.least_width_mm", supports.least_width_mm, kGap, "Narrower supports are left out.");
  schema.number("supports.join_mm", supports.join_mm, kGap, "Narrower gaps between columns are closed.");
  schema.number("supports.expand_mm", supports.expand_mm, kGap,
                "By how much supports are wider than what they hold up.");
}

}  // namespace

void describe(SettingsSchema& schema, SupportSettings& supports) {
  schema.flag("supports.use", supports.use, "Whether overhangs of level or inclined layers are held up.");
  schema.choice<SupportKind>("supports.kind", supports.kind,
                             {{"lattice", SupportKind::Lattice}, {"tree", SupportKind::Tree}},
                             "Columns filled with lines, or branches.");
  schema.choice<SupportFoot>("supports.foot", supports.foot,
                             {{"bed", SupportFoot::Bed}, {"everywhere", SupportFoot::Everywhere}},
                             "Whether supports stand on the bed only, or on the part too.");
  schema.flag("supports.under_bridges", supports.under_bridges,
              "Whether overhangs that bridges span are held up too.");
  schema.number("supports.angle_deg", supports.angle_deg, {0.0, 89.0},
                "Lean of walls from the layers' normal beyond which they are held up.");
  schema.number("supports.bead_width_mm", supports.bead_width_mm, {0.0, 100.0},
                "Width of beads of supports; 0 takes bead.width_mm, in proportion to the nozzles.");
  schema.number("supports.density", supports.density, kDensity, "Part of the columns that is filled.");
  schema.number("supports.raster_angle_deg", supports.raster_angle_deg, {-180.0, 180.0},
                "Direction of the lines in all layers, from x.");
  schema.integer("supports.walls", supports.walls, {0, 100}, "Number of loops round each column.");
  describeSizes(schema, supports);
  describeBranches(schema, supports);
  schema.integer("supports.tool", supports.tool, kTool,
                 "Tool that lays supports; -1 takes that of the part.");
  schema.integer("supports.interface_tool", supports.interface_tool, kTool,
                 "Tool that lays their interfaces; -1 takes that of the part.");
}

}  // namespace lamina
