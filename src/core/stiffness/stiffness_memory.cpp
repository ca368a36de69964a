// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness_memory.hpp"

#include <cmath>
#include <string>

#include "lamina/base/available_memory.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMebibyte = 1048576.0;

// Four fields in double precision and three in single, one number more, and a quarter of the latter for the
// coarser lattices; some more for nodes that are given.
constexpr double kBytesOfNode = 4 * 24.0 + 1.25 * (3 * 12.0 + 4.0) + 14.0;
// Density and run, and the stress.
constexpr double kBytesOfElement = 16.0 + 24.0;

}  // namespace

double stiffnessBytes(double elements, double nodes) {
  return kBytesOfElement * elements + kBytesOfNode * nodes;
}

void requireMemory(double needed, int limit_mb, double voxel_mm) {
  const double limit = limit_mb > 0 ? kMebibyte * limit_mb : availableMemory();
  if (needed <= limit) return;
  // Elements, and what they need, go with the third power of the voxel.
  const double fitting = voxel_mm * std::cbrt(needed / limit);
  throw InvalidInput("stiffness at voxels of " + numberText(voxel_mm) + " mm needs " +
                     std::to_string(std::llround(needed / kMebibyte)) + " MiB; may use " +
                     std::to_string(std::llround(limit / kMebibyte)) + " MiB, which voxels of " +
                     numberText(std::ceil(100.0 * fitting * 1.01) / 100.0) + " mm would fit");
}

}  // namespace lamina
