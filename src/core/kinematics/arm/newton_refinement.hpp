// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/arm/arm_inverse.hpp"

namespace lamina {

/// Joint values that bring the nozzle to the pose within 1e-7 mm and 1e-10 rad, by Newton's method from
/// values near them, in (-pi, pi]. None if it does not get there.
std::optional<ArmValues> refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle,
                                 ArmValues values);

/// Those solutions that get there, refined.
ArmSolutions refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle, ArmSolutions found);

/// With values in (-pi, pi].
ArmSolutions wrappedValues(ArmSolutions found);

}  // namespace lamina
