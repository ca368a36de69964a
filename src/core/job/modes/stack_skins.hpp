// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// For each layer of a stack whether it is a skin as a whole: as many of the first and of the last layers as
/// `skins` asks for, by number, or by thickness divided by `layer_height_mm`.
std::vector<bool> skinsOfStack(std::size_t layers, const SkinSettings& skins, double layer_height_mm);

/// A stack as it is planned flat.
struct FlatStack {
  const std::vector<Layer>& plans;                     ///< level layers at their heights
  const std::vector<std::vector<LayerChart>>& charts;  ///< of each layer; none if it is level
  const std::vector<bool>& is_skin;                    ///< as a whole
};

/// What covers each layer of a stack: level layers by sections of the part above and below them, also where
/// the stack's own layers bend there; others by the part along their growth (`coverOnCharts`). Layers that
/// are skins as a whole have none.
/// @param part  closed, in the frame of the stack; empty: there are no covers
/// @return none if the settings ask for no skins beside a sparse infill (`takesSkins`)
std::vector<LayerCover> coversOfStack(const FlatStack& stack, const Mesh& part, const JobSettings& settings,
                                      Progress& progress);

/// The covers without those of layers that are skins as a whole.
std::vector<LayerCover> dividedOnly(std::vector<LayerCover> covers, const std::vector<bool>& is_skin);

}  // namespace lamina
