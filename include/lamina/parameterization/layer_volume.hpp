// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// What a layer fills: the sum of its triangles' areas by their mean heights [mm³].
double volume(const LayerSurface& layer);
double volume(const std::vector<LayerSurface>& layers);

}  // namespace lamina
