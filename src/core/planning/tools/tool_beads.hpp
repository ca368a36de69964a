// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The nominal bead of a role in a layer.
struct RoleBead {
  Bead bead;
  double pitch_mm = 0.0;  ///< distance of neighbours at which they fill the layer, or `bead.pitch_mm`
};

/// The nominal bead of a role. Infill, skins and supports have the width that the settings state for them,
/// with any tool. Otherwise the bead is `bead.width_mm` wide with the tool of walls, and with other tools
/// (those of supports, brims and rafts included) in proportion to the nozzle diameter. If a nozzle diameter
/// is not known, and for bridges and ironing, the bead has the width of walls.
/// @param height_mm  height of the bead
RoleBead beadOf(PathRole role, const PlanSettings& settings, double height_mm);

/// The nominal beads of a layer.
struct LayerBeads {
  RoleBead walls;  ///< of walls and all other roles
  RoleBead infill;
  RoleBead skins;

  const RoleBead& of(PathRole role) const;
};

LayerBeads beadsByRole(const PlanSettings& settings, double height_mm);

/// A tool and the one with which its nozzle is compared.
struct ComparedTools {
  std::size_t tool = 0;
  std::size_t by = 0;
};

/// Nozzle diameter of `tool` over that of `by`; 1 if either is not known.
double nozzleShare(const ComparedTools& compared, const ToolSettings& settings);

}  // namespace lamina
