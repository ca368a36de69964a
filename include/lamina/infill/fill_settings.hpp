// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/contour/contour_settings.hpp"
#include "lamina/infill/contour/perimeters_settings.hpp"
#include "lamina/infill/contour/smoothing_settings.hpp"
#include "lamina/infill/contour/vase_settings.hpp"
#include "lamina/infill/drops/drop_settings.hpp"
#include "lamina/infill/hilbert/hilbert_settings.hpp"
#include "lamina/infill/lightning/lightning_settings.hpp"
#include "lamina/infill/rectilinear/hybrid_settings.hpp"
#include "lamina/infill/rectilinear/raster_settings.hpp"

namespace lamina {

/// Settings of each family of infill strategies, besides spacing and angle.
struct FillSettings {
  RasterSettings raster;
  HybridSettings hybrid;
  PerimetersSettings perimeters;
  ContourSettings contour;
  VaseSettings vase;
  HilbertSettings hilbert;
  LightningSettings lightning;
  DropSettings drops;
  SmoothingSettings smoothing;  ///< for all families
};

/// Adds the keys of all families.
void describe(SettingsSchema& schema, FillSettings& settings);

}  // namespace lamina
