// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Values of the external axes of an arm, in their order [mm, deg].
std::vector<double> externalAxes(const KinematicModel& arm, const JointValues& values);

std::vector<JointKind> externalAxisKinds(const KinematicModel& arm);

/// Joint values with those of the external axes replaced. Surplus values in `external` are ignored.
/// @return nothing if the value of an external axis is missing
std::optional<JointValues> withExternalAxes(const KinematicModel& arm, JointValues values,
                                            const std::vector<double>& external);

}  // namespace lamina
