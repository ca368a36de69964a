// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/planning/compensation/compensation_settings.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Regions with their outer outlines and holes moved, each by what the settings take off [mm]. A hole's width
/// is the diameter of the circle of its area. What grows together becomes one.
Regions compensated(const Regions& regions, const CompensationSettings& settings);

/// Regions shrunk by `inset_mm`, but for places narrower than `bead_width_mm` and two insets: they stay as
/// they are, and joined to the rest.
Regions insetOnBed(const Regions& regions, double inset_mm, double bead_width_mm);

/// By how much outlines of a layer are shrunk, counted from 0 at the bed [mm].
double insetOf(std::size_t layer, const FirstLayerSettings& settings);

/// The contours of layers as they are to be laid: outlines, holes, and the layers that are squeezed out on
/// the bed. Nothing changes where nothing is set. Parallel over layers.
/// @param layers         from the bed
/// @param bead_width_mm  in the first layers
/// @throws Cancelled
void compensate(std::vector<Layer>& layers, const CompensationSettings& settings,
                const FirstLayerSettings& first_layer, double bead_width_mm, Progress& progress);

/// Factors on the size of a part that shrinks by those shares, 1 / (1 - share), in the layers and across.
Point3 shrinkageFactors(const CompensationSettings& settings);

}  // namespace lamina
