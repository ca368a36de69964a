// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "job/plate/plate_toolpath.hpp"

namespace lamina {

/// Refuses supports, brims and rafts whose beads meet those of another part, its supports included, at any
/// height. Beads may lie side by side.
/// @throws InvalidInput naming both parts, what meets, and the place
void requireAidsApart(const std::vector<PlateToolpath>& parts);

}  // namespace lamina
