// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

enum class SupportKind {
  Lattice,  ///< columns as wide as the overhang, filled with lines
  Tree,     ///< branches that merge on their way down
};

/// Surfaces on which supports may stand.
enum class SupportFoot { Bed, Everywhere };

/// Structures that support overhangs, and are removed after printing.
struct SupportSettings {
  bool use = false;
  SupportKind kind = SupportKind::Lattice;
  SupportFoot foot = SupportFoot::Everywhere;
  bool under_bridges = false;  ///< whether bridges are supported too
  double angle_deg = 50.0;     ///< greatest lean of a wall from the layers' normal without support
  double bead_width_mm = 0.0;  ///< 0: the width of walls, in proportion to the nozzles of their tools
  double density = 0.15;
  double raster_angle_deg = 0.0;  ///< angle of the lines, in all layers; the lines of interfaces lie across
  int walls = 0;                  ///< loops round each column
  double top_gap_mm = 0.2;        ///< between support and overhang
  double bottom_gap_mm = 0.2;     ///< between a support and the part on which it stands
  double side_gap_mm = 0.6;       ///< between a support and walls beside it
  int interface_layers = 2;       ///< number of dense layers below the overhang, and on the part
  double interface_density = 0.8;
  double least_width_mm = 0.4;  ///< narrower overhangs and columns are left out
  double join_mm = 2.0;         ///< narrower gaps between columns are closed
  double expand_mm = 0.0;       ///< extension of the supported area beyond the overhang
  double tip_mm = 0.8;          ///< diameter of a support below a single point, and of the tips of branches
  double tip_spacing_mm = 2.0;  ///< distance of neighbouring tips
  double branch_angle_deg = 40.0;  ///< greatest lean of a branch
  double branch_taper_deg = 5.0;   ///< angle by which each side of a branch widens downwards
  double branch_mm = 6.0;          ///< greatest diameter of a branch
  int tool = -1;                   ///< -1: the tool of the part
  int interface_tool = -1;         ///< -1: the tool of the part
};

/// Adds the keys supports.*.
void describe(SettingsSchema& schema, SupportSettings& supports);

}  // namespace lamina
