// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/scaffold/scaffold_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A convex outline in every layer, filled: see `makeScaffold`.
/// @param outline   about its middle, counter-clockwise [mm]
/// @param settings  within their bounds
/// @throws InvalidConfig if a layer has no room for any bead
Toolpath filledShape(const std::string& name, const Polygon& outline, const ScaffoldSettings& settings);

}  // namespace lamina
