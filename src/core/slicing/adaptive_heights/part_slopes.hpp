// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Heights and slope of a face.
struct FaceSlope {
  double low_mm = 0.0;
  double high_mm = 0.0;
  double slope = 0.0;  ///< |n_z|: 0 on walls, 1 on level faces
  double area_mm2 = 0.0;

  /// Whether the face is within 2.6 deg of level and no higher than a layer, so that lower layers would not
  /// reduce its steps.
  bool isFlat(double layer_height_mm) const;
};

FaceSlope slopeOf(const Mesh& mesh, const Triangle& face);

/// The greatest slope of a part at each height.
struct SlopeProfile {
  std::vector<double> z_mm;  ///< heights of the vertices, ascending, without duplicates
  /// Greatest slope between z_mm[i] and z_mm[i + 1]; 0 if there are only flats and walls.
  std::vector<double> slope;
};

/// A level face, or several at the same height.
struct Flat {
  double z_mm = 0.0;
  double area_mm2 = 0.0;
};

/// The greatest slope of a mesh by height.
/// @param least_height_mm  least height of a layer: faces near to level that are lower count as flats
SlopeProfile slopeProfile(const Mesh& mesh, double least_height_mm);

/// Level faces at which a layer could end, ascending, without those at the bottom of the part. Of several
/// faces closer to each other than `least_height_mm`, `kept` has the largest and `hidden` the others.
struct Flats {
  std::vector<Flat> kept;
  std::vector<Flat> hidden;
};
Flats flatsOf(const Mesh& mesh, double least_height_mm);

}  // namespace lamina
