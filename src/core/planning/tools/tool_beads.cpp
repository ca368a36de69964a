// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_beads.hpp"

#include <vector>

#include "planning/tools/tool_order.hpp"

namespace lamina {

double nozzleShare(const ComparedTools& compared, const ToolSettings& settings) {
  if (compared.tool == compared.by || settings.list.empty()) return 1.0;
  const std::vector<Tool> tools = toolsOf(settings);
  if (compared.tool >= tools.size() || compared.by >= tools.size()) return 1.0;
  const double nozzle_mm = tools[compared.tool].nozzle_mm;
  const double by_mm = tools[compared.by].nozzle_mm;
  return nozzle_mm > 0.0 && by_mm > 0.0 ? nozzle_mm / by_mm : 1.0;
}

RoleBead beadOf(PathRole role, const PlanSettings& settings, double height_mm) {
  // Threads over a gap and what is ironed are spaced as the walls' beads are.
  const bool is_of_walls = role == PathRole::Bridge || role == PathRole::Ironing;
  const std::size_t walls = toolFor(PathRole::OuterWall, settings.tools);
  const double share = is_of_walls ? 1.0 : nozzleShare({toolOf(role, settings), walls}, settings.tools);
  const BeadSettings& bead = settings.bead;
  RoleBead of_role;
  of_role.bead = {share * bead.width_mm, height_mm};
  of_role.pitch_mm = bead.pitch_mm > 0.0 ? share * bead.pitch_mm : planWidth(of_role.bead);
  return of_role;
}

const RoleBead& LayerBeads::of(PathRole role) const {
  const bool is_skin = role == PathRole::Skin || role == PathRole::TopSkin || role == PathRole::BottomSkin;
  if (is_skin) return skins;
  return role == PathRole::Infill ? infill : walls;
}

LayerBeads beadsByRole(const PlanSettings& settings, double height_mm) {
  return {beadOf(PathRole::OuterWall, settings, height_mm), beadOf(PathRole::Infill, settings, height_mm),
          beadOf(PathRole::Skin, settings, height_mm)};
}

}  // namespace lamina
