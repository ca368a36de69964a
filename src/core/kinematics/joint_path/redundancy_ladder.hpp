// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/joint_path/stations.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"

namespace lamina {

/// Sets the redundancy of stations, whose external axes are set. A ladder over landmarks, stations some 10 mm
/// apart and the ends of travels, has a row of samples for each of `redundancy_samples` angles, with fewer
/// yaws than the ladder over all stations. The angles of the cheapest path through the ladder are evened out
/// within half a sample, and change steadily in time between landmarks. With one sample the angle is held at
/// 0. Does nothing if the model is not redundant.
/// @throws Cancelled
void resolveRedundancy(std::vector<Station>& stations, const GuardedModel& guarded,
                       const JointPathSettings& settings, Progress& progress);

}  // namespace lamina
