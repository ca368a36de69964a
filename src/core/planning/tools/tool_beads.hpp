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
  double pitch_mm = 0.0;  ///< distance at which neighbours fill the layer, or `bead.pitch_mm`
};

/// The nominal bead of a role. It has the width stated for infill, skins or supports, by whatever tool. Else
/// it is `bead.width_mm` wide for the tool of walls, and for other tools, those of supports, brims and rafts
/// too, wider or narrower in proportion to their nozzles. If a nozzle is not known, and for bridges and
/// ironing, it has the width of walls.
/// @param height_mm  of the bead
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
