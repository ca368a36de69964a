// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"

namespace lamina {

enum class SupportKind {
  Lattice,  ///< columns as wide as what they hold up, filled with lines
  Tree,     ///< branches that meet on their way down
};

/// What supports may stand on.
enum class SupportFoot { Bed, Everywhere };

/// Structures that hold up what would be laid over nothing, and are taken away.
struct SupportSettings {
  bool use = false;
  SupportKind kind = SupportKind::Lattice;
  SupportFoot foot = SupportFoot::Everywhere;
  bool under_bridges = false;  ///< whether what bridges span is held up too
  double angle_deg = 50.0;     ///< of a wall from the layers' normal; what leans more is held up
  double density = 0.15;
  double raster_angle_deg = 0.0;  ///< of the lines, in all layers; interfaces lie across
  int walls = 0;                  ///< loops round each column
  double top_gap_mm = 0.2;        ///< between support and what it holds up
  double bottom_gap_mm = 0.2;     ///< between a support and the part it stands on
  double side_gap_mm = 0.6;
  int interface_layers = 2;  ///< dense ones below what is held up, and on the part
  double interface_density = 0.8;
  double least_width_mm = 0.4;  ///< narrower overhangs and columns are left out
  double join_mm = 2.0;         ///< narrower gaps between columns are closed
  double expand_mm = 0.0;       ///< of what is held up, sideways
  double tip_mm = 0.8;          ///< diameter of what holds up a point, and of the tips of branches
  double tip_spacing_mm = 2.0;
  double branch_angle_deg = 40.0;  ///< most lean of a branch
  double branch_taper_deg = 5.0;   ///< half of it on each side
  double branch_mm = 6.0;          ///< greatest diameter
  int tool = -1;                   ///< -1 takes that of the part
  int interface_tool = -1;
};

/// Adds the keys supports.*.
void describe(SettingsSchema& schema, SupportSettings& supports);

}  // namespace lamina
