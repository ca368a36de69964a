// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/planning/hooks/hook_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where a program's part stands, and what else placeholders tell of.
struct HookSite {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  Eigen::Affine3d program_from_bed = Eigen::Affine3d::Identity();  ///< see `ProgramFrame`
  double nozzle_temperature_c = 0.0;
  double bed_temperature_c = 0.0;
  MotionLimits limits;
};

/// Adds a way to a parking place, and a pause there, before the first bead of each layer that the settings
/// name, and of the first layer that begins at or above each height over the bed. A layer that lays nothing
/// passes it on to the next. Several at one layer are one.
/// @param parking  lift and place
/// @throws InvalidConfig if there is no such layer, or none above that height
void addPauses(Toolpath& toolpath, const PauseSettings& settings, const CoolingSettings& parking,
               const HookSite& site);

/// Adds code as events. Where each stands:
/// - of a layer, a role, a layer's number or a height: before the first bead concerned, after the travel to
/// it;
/// - of the end of a role: before the next travel;
/// - of the end of a layer: after its last path;
/// - of the part: before its first motion and after its last;
/// - of a tool: after the change; of a pause: before it.
/// A role is entered when the bead before, in whatever layer, has another.
///
/// Placeholders: {layer} from 0, {layers}, {z_mm} and {height_mm} of the layer, {time_s} since the start,
/// {left_s} and {share} of the estimated time, {role}, {part}, {tool} and the {next_tool} after it,
/// {nozzle_temperature_c}, {bed_temperature_c}, {x_mm} and {y_mm} of the nozzle in the program. A line whose
/// placeholder has no value (no next tool, 0 deg C) is left out.
/// @throws InvalidConfig as `requireConsistent`; if there is no such layer, or none above that height
void addHooks(Toolpath& toolpath, const HookSettings& settings, const HookSite& site);

}  // namespace lamina
