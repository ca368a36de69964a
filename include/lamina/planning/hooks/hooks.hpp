// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/planning/hooks/hook_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The values that placeholders need: the place of the part, temperatures and limits.
struct HookSite {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  Eigen::Affine3d program_from_bed = Eigen::Affine3d::Identity();  ///< see `ProgramFrame`
  double nozzle_temperature_c = 0.0;
  double bed_temperature_c = 0.0;
  MotionLimits limits;
};

/// Adds pauses at a parking place, with the travels there and back. A layer of the settings has a pause
/// before its first bead. A height of the settings has a pause before the first bead of the first layer that
/// begins at or above this height over the bed. If parts are deposited one after the other, every part that
/// is high enough has such a pause. The pause of a layer without beads moves to the next layer with beads.
/// Several pauses in one layer become one.
/// @param parking  lift and place of parking
/// @throws InvalidConfig if a layer does not exist, or no layer begins at or above a height
void addPauses(Toolpath& toolpath, const PauseSettings& settings, const CoolingSettings& parking,
               const HookSite& site);

/// Adds the code of the settings as events, at these places:
/// - start of a layer, start of a role, a layer's number, a height: after the travel to its first bead;
/// - end of a role: before the next travel;
/// - end of a layer: after its last path;
/// - start and end of the part: before its first motion and after its last;
/// - change of a tool: after it;
/// - pause: before it.
///
/// A role starts at a bead if the bead before it, in any layer, has another role.
///
/// Placeholders: {layer} from 0, {layers}, {z_mm} and {height_mm} of the layer, {time_s} since the start,
/// {left_s} and {share} of the estimated time, {role}, {part}, {tool} and the {next_tool} after it,
/// {nozzle_temperature_c}, {bed_temperature_c}, {x_mm} and {y_mm} of the nozzle in the program. A line whose
/// placeholder has no value (no next tool, 0 deg C) is left out.
/// @throws InvalidConfig as `requireConsistent`; if a layer does not exist, or no layer begins at or above a
///   height
void addHooks(Toolpath& toolpath, const HookSettings& settings, const HookSite& site);

}  // namespace lamina
