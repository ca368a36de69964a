// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// Volume of a layer [mm³]: the sum over its triangles of area times mean height.
double volume(const LayerSurface& layer);
double volume(const std::vector<LayerSurface>& layers);

}  // namespace lamina
