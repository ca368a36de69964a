// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The regions that outlines bound which are simple and do not meet: each counter-clockwise one with the
/// clockwise ones directly inside it. None if they wind round some point more than once or less than not at
/// all, or if there are so many that comparing each with each would take long.
std::optional<Regions> nest(std::vector<Polygon> outlines);

}  // namespace lamina
