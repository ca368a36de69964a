// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The regions bounded by outlines that are simple and do not meet: each counter-clockwise outline with the
/// clockwise ones directly inside it. Nothing if the winding number of a point is neither zero nor one.
std::optional<Regions> nest(std::vector<Polygon> outlines);

}  // namespace lamina
