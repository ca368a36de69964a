// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/height_field/height_field.hpp"
#include "lamina/slicing/height_field/height_field_settings.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// How well bent layers follow a part.
struct HeightFieldReport {
  double greatest_slope_deg = 0.0;  ///< steepest slope of the layers where there is material
  /// Least vertical thickness of the layers where there is material; the first layer is not considered.
  double least_thickness_mm = 0.0;
  double greatest_thickness_mm = 0.0;  ///< greatest vertical thickness, by the same rule
  double share = 1.0;                  ///< share of the bend that remains after it is scaled to the limits
  double upper_mm2 = 0.0;              ///< area of the part's upper side, seen from above
  /// Area of the upper side that layers follow: neither too steep nor too low.
  double followed_mm2 = 0.0;
  /// Mean number of stair-steps, at the edges of layers, per mm in the direction of steepest slope, seen from
  /// above, on the surface that is followed: with level layers of the same settings, and with bent ones.
  double level_steps_per_mm = 0.0;
  double bent_steps_per_mm = 0.0;
  /// Mean vertical distance from the surface that is followed to the top of the nearest layer: with level
  /// layers of the same settings, and with bent ones.
  double level_error_mm = 0.0;
  double bent_error_mm = 0.0;
};

/// Notes for the user, one sentence each.
std::vector<std::string> notesOf(const HeightFieldReport& report, const HeightFieldSettings& settings);

/// A part in bent layers.
struct HeightFieldSlices {
  HeightField field;
  std::vector<Layer> layers;  ///< the layers before they are bent, level; bending does not change x and y
  double top_mm = 0.0;        ///< z of the highest point of the part [part frame]
  HeightFieldReport report;
};

/// Cuts a part into layers for machines that cannot tilt: flat on the bed, and bent more with height. The
/// uppermost layers follow the upper side of the part, except where it is too steep. The bend is a height
/// field found by least squares, as in QuickCurve (arXiv 2406.03966). It is scaled down as a whole until
/// slope and thickness are within their limits; the report states the share that is left.
///
/// @param mesh  closed [mm, part frame]; it stands on its lowest point
/// @throws InvalidMesh if the mesh has no triangle or no height
/// @throws InvalidConfig if a setting is out of range, or the grid would have more than four million cells
/// @throws InvalidInput if the system of equations cannot be solved; Cancelled
HeightFieldSlices sliceByHeightField(const Mesh& mesh, const SlicingSettings& slicing,
                                     const HeightFieldSettings& settings, Progress& progress);

}  // namespace lamina
