// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/arm/arm_inverse.hpp"

namespace lamina {

/// Joint values in (-pi, pi] that bring the nozzle to a pose within 1e-7 mm and 1e-10 rad, by Newton's method
/// from the given values. Nothing if it does not converge.
std::optional<ArmValues> refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle,
                                 ArmValues values);

/// The solutions refined by Newton's method, without those for which it does not converge.
ArmSolutions refined(const SerialChain& arm, const Eigen::Isometry3d& bed_from_nozzle, ArmSolutions found);

/// The solutions with joint values wrapped into (-pi, pi].
ArmSolutions wrappedValues(ArmSolutions found);

}  // namespace lamina
