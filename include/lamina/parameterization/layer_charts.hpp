// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/flattening_settings.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// Parameterizes a layer: cuts it into charts, each of which can be laid out flat. A piece of the layer stays
/// whole if in its parameterization no triangle is flipped, none overlap, and lengths in the plane differ
/// from those on the surface by no more than the tolerance. Otherwise it is cut along creases that keep it
/// from lying flat, or else in two, along the line midway between two vertices that are far from each other.
/// Each part is then tried again. Parts share their border exactly. Plane pieces keep their shape but for
/// rounding. In pieces of at most the area of a bead (a square twice as wide as the layer is high) lengths
/// may differ by more. Pieces of at most a tenth of this area that still need a cut, and pieces of at most
/// 1e-9 mm², are left out, as they have no room for a bead.
///
/// Each parameterization is turned and moved so that it lies nearest to the projection of its chart to the xy
/// plane, by least squares, so that a direction means the same in all layers. Where the bounding boxes of two
/// parameterizations overlap, the later one is moved beyond the others in y, into rows 10 mm apart; level
/// pieces at one height stay where they are.
///
/// @return the charts, by connected pieces of the layer in the order of the layer's triangles; none for an
///   empty layer
/// @param progress  receives "flatten", by area; cancellation is checked before each step on a piece
/// @throws InvalidMesh naming the place [mm] if a piece that is not left out still has no parameterization
///   after 30 cuts; Cancelled
std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings,
                                    Progress& progress);

/// The same, without progress and cancellation, for small layers.
std::vector<LayerChart> layerCharts(const LayerSurface& layer, const FlatteningSettings& settings);

}  // namespace lamina
