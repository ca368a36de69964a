// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/trajectory/timed_path.hpp"

namespace lamina {

/// Settings by which a machine or robot runs a toolpath.
struct RunSettings {
  JointPathSettings joints;
  TimingSettings timing;
};

/// Adds the keys joints.*, motion.*, trajectory.* and process.*.
void describe(SettingsSchema& schema, RunSettings& settings);

/// Checks the settings.
/// @throws InvalidConfig naming key, value and bound
void validate(const RunSettings& settings);

/// The run settings within the settings of a job.
RunSettings runSettings(const JobSettings& settings);

}  // namespace lamina
