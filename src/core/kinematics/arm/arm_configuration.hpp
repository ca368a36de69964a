// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/arm/arm_inverse.hpp"

namespace lamina {

/// Sines of an arm of any geometry; 1 where one is not defined:
/// shoulder if axis 2 is no parallel of axis 1, by the point of axis 5 that is nearest to axis 6;
/// elbow if axes 2 and 3 are parallel, by axis 4, or where it is nearest to axis 5 if it is no parallel of 3;
/// wrist as the triple product of axes 4, 5 and 6.
ArmSines generalSines(const SerialChain& arm, const ArmValues& values);

}  // namespace lamina
