// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/parameterization/flattening_settings.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// A layer as charts: laid out flat, and cut where it does not lie flat. A piece of the layer stays whole if
/// in its parameterization no triangle is flipped, none overlap, and lengths differ by no more than the
/// tolerance; otherwise it is cut along creases that keep it from lying flat, or else in two along the line
/// midway between two far places, and each part is tried again. Parts share their border exactly. Plane
/// pieces keep their shape to rounding. Lengths in pieces no larger than a bead (a square twice as wide as
/// the layer is high) need not be true. Pieces of a tenth of that square which still overlap themselves, and
/// those of less than 1e-9 mm², are left out: no bead finds room in them.
///
/// Each parameterization lies on the projection of its chart to the xy plane as well as it can by turning and
/// moving, so that directions mean the same in all layers. Where the boxes of two parameterizations overlap,
/// the later one is moved beyond the others in y, into rows 10 mm apart; level pieces at one height stay
/// where they are.
///
/// @return in the order of the triangles of the layer, as far as they were not cut; none for an empty layer
/// @throws InvalidMesh naming the place [mm] if a larger piece still has no parameterization after 30 cuts
std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings);

}  // namespace lamina
