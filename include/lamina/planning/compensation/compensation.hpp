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

/// The regions with their outer outlines and holes offset as the settings say. A hole's width is the diameter
/// of the circle with the same area. Regions that grow together become one.
Regions compensated(const Regions& regions, const CompensationSettings& settings);

/// Regions shrunk by `inset_mm`. Places narrower than `bead_width_mm` plus two insets stay as they are, and
/// remain joined to the rest.
Regions insetOnBed(const Regions& regions, double inset_mm, double bead_width_mm);

/// The inset of outlines in a layer [mm].
/// @param layer  number, from 0 at the bed
double insetOf(std::size_t layer, const FirstLayerSettings& settings);

/// Compensates the contours of layers: offsets outlines and holes, and insets the first layers, whose beads
/// the bed squeezes out. Without effect for default settings. Parallel over layers.
/// @param layers  layers from the bed upwards
/// @param bead_width_mm  width of beads in the first layers
/// @throws Cancelled
void compensate(std::vector<Layer>& layers, const CompensationSettings& settings,
                const FirstLayerSettings& first_layer, double bead_width_mm, Progress& progress);

/// Factors on the size of a part that make up for its shrinkage, 1 / (1 - share), in x, y and across the
/// layers.
Point3 shrinkageFactors(const CompensationSettings& settings);

}  // namespace lamina
