// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "lamina/job/drivable_toolpath.hpp"

namespace lamina {

/// Parameter of the namespace in which nodes run: the sheet (`driveSettingsSheet`) of the driver there, as it
/// was started last.
inline constexpr char kDriveSettingsParameter[] = "drive_settings";

/// States by which settings a driver checks its jobs.
inline void tellDriveSettings(const ros::NodeHandle& node, const DriveCheckSettings& settings) {
  node.setParam(kDriveSettingsParameter, driveSettingsSheet(settings));
}

/// Refuses settings of a unit that differ from those of the driver in its namespace; none are refused as long
/// as no driver has been started there.
/// @throws InvalidConfig as `requireSameDriveSettings`
inline void requireDriveSettings(const ros::NodeHandle& node, const DriveCheckSettings& unit) {
  std::string sheet;
  if (node.getParam(kDriveSettingsParameter, sheet)) requireSameDriveSettings(unit, sheet);
}

}  // namespace lamina
