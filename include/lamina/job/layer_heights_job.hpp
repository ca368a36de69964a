// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/slicing/adaptive_heights/adaptive_layers.hpp"

namespace lamina {

/// How a part is stacked from plane layers.
struct LayerHeightsReport {
  std::vector<LayerBounds> bounds;
  std::vector<MissedFlat> missed;  ///< of adaptive heights
  double greatest_cusp_mm = 0.0;   ///< `greatestCusp` above the first layer; 0 if they are equal
};

/// The layers of a part, as `slicing.heights` says: equal, adaptive, or from a table.
/// @param mesh  turned so that the layers are level
/// @throws as `stackLayers`, `adaptiveLayers`, `readHeightTable`
LayerHeightsReport layerHeightsOf(const Mesh& mesh, const SlicingSettings& settings);

/// What a user should know of heights that are not equal, a sentence each.
std::vector<std::string> notesOn(const LayerHeightsReport& report, const SlicingSettings& settings);

/// The layers of a job's part, with their cusp measured whatever their heights, and the table of them in the
/// job's output, if it has one.
/// @throws FileError, InvalidMesh, InvalidConfig (also for layers that are not plane), InvalidInput
LayerHeightsReport runLayerHeightsJob(const SliceJob& job);

}  // namespace lamina
