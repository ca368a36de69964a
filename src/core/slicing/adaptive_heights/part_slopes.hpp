// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// How a face lies.
struct FaceSlope {
  double low_mm = 0.0;
  double high_mm = 0.0;
  double slope = 0.0;  ///< |n_z|: 0 on walls, 1 on level faces
  double area_mm2 = 0.0;

  /// Within 2.6 deg of level, and within one layer of that height: no step to be lowered.
  bool isFlat(double layer_height_mm) const;
};

FaceSlope slopeOf(const Mesh& mesh, const Triangle& face);

/// The greatest slope of a part at each height.
struct SlopeProfile {
  std::vector<double> z_mm;   ///< of the vertices, ascending, each once
  std::vector<double> slope;  ///< between z_mm[i] and z_mm[i + 1]; 0 where only flats and walls are
};

/// A level face, or several at one height.
struct Flat {
  double z_mm = 0.0;
  double area_mm2 = 0.0;
};

/// @param least_height_mm  of a layer: lower faces near to level are flats
SlopeProfile slopeProfile(const Mesh& mesh, double least_height_mm);

/// Level faces that a layer could end at, ascending, without those at the bottom of the part. Of those closer
/// to each other than `least_height_mm` only the largest; `hidden` holds the others.
struct Flats {
  std::vector<Flat> kept;
  std::vector<Flat> hidden;
};
Flats flatsOf(const Mesh& mesh, double least_height_mm);

}  // namespace lamina
