// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_beads.hpp"

#include <vector>

#include "planning/tools/tool_order.hpp"

namespace lamina {
namespace {

bool isSkin(PathRole role) {
  return role == PathRole::Skin || role == PathRole::TopSkin || role == PathRole::BottomSkin;
}

/// 0 if none is stated.
double statedWidth(PathRole role, const PlanSettings& settings) {
  if (isSkin(role)) return settings.skins.bead_width_mm;
  if (role == PathRole::Infill) return settings.infill.bead_width_mm;
  const bool is_support = role == PathRole::Support || role == PathRole::SupportInterface;
  return is_support ? settings.supports.bead_width_mm : 0.0;
}

/// Of the width of walls.
double widthShare(PathRole role, const PlanSettings& settings) {
  const double stated_mm = statedWidth(role, settings);
  if (stated_mm > 0.0) return stated_mm / settings.bead.width_mm;
  // Threads over a gap and what is ironed are spaced as the walls' beads are.
  if (role == PathRole::Bridge || role == PathRole::Ironing) return 1.0;
  const std::size_t walls = toolFor(PathRole::OuterWall, settings.tools);
  return nozzleShare({toolOf(role, settings), walls}, settings.tools);
}

}  // namespace

double nozzleShare(const ComparedTools& compared, const ToolSettings& settings) {
  if (compared.tool == compared.by || settings.list.empty()) return 1.0;
  const std::vector<Tool> tools = toolsOf(settings);
  if (compared.tool >= tools.size() || compared.by >= tools.size()) return 1.0;
  const double nozzle_mm = tools[compared.tool].nozzle_mm;
  const double by_mm = tools[compared.by].nozzle_mm;
  return nozzle_mm > 0.0 && by_mm > 0.0 ? nozzle_mm / by_mm : 1.0;
}

RoleBead beadOf(PathRole role, const PlanSettings& settings, double height_mm) {
  const BeadSettings& bead = settings.bead;
  const double share = widthShare(role, settings);
  RoleBead of_role;
  of_role.bead = {share * bead.width_mm, height_mm};
  of_role.pitch_mm = bead.pitch_mm > 0.0 ? share * bead.pitch_mm : planWidth(of_role.bead);
  return of_role;
}

const RoleBead& LayerBeads::of(PathRole role) const {
  if (isSkin(role)) return skins;
  return role == PathRole::Infill ? infill : walls;
}

LayerBeads beadsByRole(const PlanSettings& settings, double height_mm) {
  return {beadOf(PathRole::OuterWall, settings, height_mm), beadOf(PathRole::Infill, settings, height_mm),
          beadOf(PathRole::Skin, settings, height_mm)};
}

}  // namespace lamina
