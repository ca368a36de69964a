// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::cli {

/// Input of a subcommand: a toolpath, and the pose of its part on the bed.
struct ToolpathInput {
  Toolpath toolpath;
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();  ///< translation [mm]
};

/// Whether the input is a part to be sliced: neither program nor toolpath.
bool isPart(const std::string& input);

/// Reads a program (.gcode, .mod; five-axis G-code through the machine of the settings) or toolpath (.csv),
/// in coordinates of the bed, or slices a part.
ToolpathInput readToolpath(const std::string& input, const JobSettings& settings);

/// The toolpath in coordinates of the bed.
Toolpath onBed(ToolpathInput input);

/// `readToolpath` for subcommands that use the tool axis. Layers and nozzle of a file that states neither are
/// oriented by `slicing.plane`.
/// @throws InvalidInput if the file states inclined layers other than those of slicing.plane
ToolpathInput readInclinedToolpath(const std::string& input, const JobSettings& settings);

}  // namespace lamina::cli
