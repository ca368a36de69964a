// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// A map of the bed as Marlin says it: a bump of Gauss' shape in the middle, probed at 5 by 5 points.
/// @param bump_mm  its height
std::string heightMapText(double bump_mm);

/// Time that probing it takes [s].
double heightMapTime();

}  // namespace lamina
