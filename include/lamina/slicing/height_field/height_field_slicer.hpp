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

/// How far bent layers follow a part.
struct HeightFieldReport {
  double greatest_slope_deg = 0.0;  ///< of any layer where there is material
  double least_thickness_mm = 0.0;  ///< of layers of the layer height
  double greatest_thickness_mm = 0.0;
  double share = 1.0;         ///< of the bend that the surface asks for, which the limits leave
  double upper_mm2 = 0.0;     ///< of the upper side, seen from above
  double followed_mm2 = 0.0;  ///< of it, what is neither too steep nor too low
  /// Mean number of layers' edges that one passes per mm on the followed surface, where it is steepest, seen
  /// from above: with level layers of the same settings, and with these. 0 where no stair-step is left.
  double level_steps_per_mm = 0.0;
  double bent_steps_per_mm = 0.0;
  /// Mean vertical distance of the followed surface from the nearest layer's top, likewise.
  double level_error_mm = 0.0;
  double bent_error_mm = 0.0;
};

/// What a user should know, a sentence each.
std::vector<std::string> notesOf(const HeightFieldReport& report, const HeightFieldSettings& settings);

/// A part in bent layers.
struct HeightFieldSlices {
  HeightField field;
  std::vector<Layer> layers;  ///< as if they were level; their outlines are those of the bent layers in xy
  double top_mm = 0.0;        ///< z of the highest place of the part
  HeightFieldReport report;
};

/// Cuts a part into layers that are flat on the bed and bend upwards, so that the uppermost follow its upper
/// side where that is not too steep: layers for machines that cannot tilt (a height field by one
/// least-squares solve, as in QuickCurve, arXiv 2406.03966). The bend is scaled down as a whole until slope
/// and thickness keep within their limits; the report states the share that was left.
///
/// @param mesh  closed [mm, part frame]; it stands on its lowest point
/// @throws InvalidMesh if it has no triangle or no height; InvalidConfig if a setting is out of range, or the
///         grid would have more than four million cells; Cancelled
HeightFieldSlices sliceByHeightField(const Mesh& mesh, const SlicingSettings& slicing,
                                     const HeightFieldSettings& settings, Progress& progress);

}  // namespace lamina
