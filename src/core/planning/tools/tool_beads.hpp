// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Nominal beads of a role in a layer.
struct RoleBead {
  Bead bead;
  double pitch_mm = 0.0;  ///< between neighbours that fill the layer, or `bead.pitch_mm`
};

/// As wide as `bead.width_mm` says for the tool of walls, and by other tools wider or narrower as their
/// nozzles are. Where a nozzle is not known, for bridges and for ironing it is the width of walls.
/// @param height_mm  of the bead
RoleBead beadOf(PathRole role, const PlanSettings& settings, double height_mm);

/// Those of a layer.
struct LayerBeads {
  RoleBead walls;  ///< and all that is neither of the others
  RoleBead infill;
  RoleBead skins;

  const RoleBead& of(PathRole role) const;
};

LayerBeads beadsByRole(const PlanSettings& settings, double height_mm);

/// A tool and the one that its nozzle is measured by.
struct ComparedTools {
  std::size_t tool = 0;
  std::size_t by = 0;
};

/// The nozzle of the one by that of the other; 1 where either is not known.
double nozzleShare(const ComparedTools& compared, const ToolSettings& settings);

}  // namespace lamina
