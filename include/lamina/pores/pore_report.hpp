// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"
#include "lamina/pores/passage.hpp"

namespace lamina {

/// Mean and population standard deviation; 0 if there are no values.
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Pore groups of one kind.
struct PoreSizes {
  std::int64_t groups = 0;
  std::int64_t voxels = 0;
  double volume_percent = 0.0;           ///< share of the volume of the whole frame
  double mean_diameter_mm = 0.0;         ///< of spheres of equal volume; 0 if there is no group
  std::array<Spread, 3> ellipsoid_mm{};  ///< axes of ellipsoids of equal second moments, longest first
};

/// Pores within the box of a voxel grid [Vega2023, section 7.2.2.4 and annex J].
struct PoreReport {
  double porosity_percent = 0.0;
  Passages passages;          ///< through all pores
  Passages joining_passages;  ///< along each axis through the groups that join its two faces
  PoreSizes all;
  PoreSizes joining_opposite;  ///< groups that join opposite faces; `volume_percent` is the thesis' CVI
  PoreSizes joining_two;  ///< groups that touch two faces; `volume_percent` is CVI_2, the interconnectivity
};

/// Examines the pores of a grid.
/// @param solid  cropped to the box that is to be examined; the whole of it counts
/// @throws InvalidInput as `labelPores`; Cancelled if `progress` is cancelled
PoreReport reportPores(const VoxelGrid& solid, Progress& progress);

}  // namespace lamina
