// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/slicing/adaptive_heights/adaptive_layers.hpp"

namespace lamina {

/// The plane layers of a part, and how well they fit its surface.
struct LayerHeightsReport {
  std::vector<LayerBounds> bounds;
  /// Level faces that lie between the ends of layers; for adaptive heights only.
  std::vector<MissedFlat> missed;
  /// `greatestCusp` of all layers but the first; `layerHeightsOf` leaves it 0 for equal heights.
  double greatest_cusp_mm = 0.0;
};

/// Cuts a part into layers as `slicing.heights` asks: of equal, adaptive or tabulated heights.
/// @param mesh  turned so that the layers are level
/// @throws as `stackLayers`, `adaptiveLayers`, `readHeightTable`
LayerHeightsReport layerHeightsOf(const Mesh& mesh, const SlicingSettings& settings);

/// Checks heights that a table states (`requireCapableOfTable`); other heights follow from settings.
void requireCapableOf(const LayerHeightsReport& report, const JobSettings& settings);

/// Notes for the user on heights that are not equal, a sentence each: their range, the greatest cusp, and
/// level faces that are missed. None for equal heights.
std::vector<std::string> notesOn(const LayerHeightsReport& report, const SlicingSettings& settings);

/// The layers of a job's part, with their greatest cusp also for equal heights. They are written as a table
/// to the job's output, if it has one.
/// @throws FileError, InvalidMesh, InvalidConfig (also for a mode whose layers are not plane), InvalidInput
LayerHeightsReport runLayerHeightsJob(const SliceJob& job);

}  // namespace lamina
