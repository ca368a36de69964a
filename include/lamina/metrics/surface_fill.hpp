// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/metrics/metrics_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How beads cover one face.
struct FaceFill {
  double area_mm2 = 0.0;
  double under_fill_mm2 = 0.0;
  double over_fill_mm2 = 0.0;
  bool has_path = false;  ///< whether any bead comes near
};

/// How beads cover the surface of a part.
struct SurfaceFill {
  std::vector<FaceFill> faces;  ///< one for each triangle of the mesh
  double under_fill_mm2 = 0.0;  ///< sum over the faces; those without a path count as the settings say
  double over_fill_mm2 = 0.0;
};

/// Measures how the beads just below each face cover it [Guacheta2021, algorithm 4-1].
///
/// The part of a bead's line within the prism below a face is projected onto the face and widened to a band
/// with round ends; a drop becomes a disc. Underfill is the area of the face that no band covers, overfill
/// the area that two or more bands cover. Areas are measured along parallel lines that are oblique to the
/// edges of the face.
///
/// Time is n log n in the number of segments and faces, and linear in the length of the bands on the surface.
///
/// @param toolpath  in the frame of the mesh
/// @param progress  stage "surface"
/// @throws Cancelled
SurfaceFill measureSurfaceFill(const Toolpath& toolpath, const Mesh& part,
                               const Eigen::Isometry3d& bed_from_part, const SurfaceFillSettings& settings,
                               Progress& progress);

}  // namespace lamina
