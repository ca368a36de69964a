// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The plan of a surface that is plane already, the same shape to rounding; nothing if it is not plane. A
/// level one keeps its x and y.
std::optional<std::vector<Point2>> planeParameterization(const Mesh& surface);

}  // namespace lamina
