// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_projection.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

bool isInner(const PoreGroup& opening) {
  const unsigned sides = faceBit(0, AxisEnd::Low) | faceBit(0, AxisEnd::High) | faceBit(1, AxisEnd::Low) |
                         faceBit(1, AxisEnd::High);
  return (opening.faces & sides) == 0;
}

std::int64_t PoreProjection::innerCount() const {
  return std::count_if(openings.groups.begin(), openings.groups.end(), isInner);
}

double PoreProjection::meanDiameterUm() const {
  constexpr double kUmPerMm = 1000.0;
  double sum = 0.0;
  for (const PoreGroup& opening : openings.groups)
    if (isInner(opening)) sum += std::sqrt(4.0 * static_cast<double>(opening.voxels) / M_PI);
  const std::int64_t count = innerCount();
  return count == 0 ? 0.0 : kUmPerMm * openings.frame.voxel_mm * sum / static_cast<double>(count);
}

PoreProjection projectPores(const VoxelGrid& solid) {
  VoxelFrame flat = solid.frame();
  flat.count[2] = 1;
  VoxelGrid shadow(flat);
  for (int k = 0; k < solid.frame().count[2]; ++k)
    for (int j = 0; j < flat.count[1]; ++j)
      for (int w = 0; w < solid.wordCount(); ++w) shadow.fillWord(w, j, 0, solid.word(w, j, k));
  NoProgress nobody;
  return {labelPores(inverted(shadow), nobody)};
}

}  // namespace lamina
