// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// A height map of the bed in Marlin's format: a bump of Gaussian shape in the middle, probed at 5 by 5
/// points.
/// @param bump_mm  height of the bump
std::string heightMapText(double bump_mm);

/// Time that the machine takes to probe the map [s].
double heightMapTime();

}  // namespace lamina
