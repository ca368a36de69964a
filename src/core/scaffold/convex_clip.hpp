// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The pieces of a polyline inside a convex outline, in order ([Cyrus1978], segment by segment).
/// @param outline  counter-clockwise
std::vector<Polyline> clippedToConvex(const Polyline& line, const Polygon& outline);

}  // namespace lamina
