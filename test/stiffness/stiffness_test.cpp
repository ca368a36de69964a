// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

VoxelGrid solidBox(int nx, int ny, int nz, double voxel_mm) {
  VoxelGrid grid({Point3(1.0, 2.0, 3.0), voxel_mm, {nx, ny, nz}});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) grid.fill(i, j, k);
  return grid;
}

StiffnessResult solved(const VoxelGrid& grid, const StiffnessSettings& settings) {
  NoProgress progress;
  return solveStiffness(grid, settings, progress);
}

// Specification, case T24.
TEST(Stiffness, ASolidCubeHasTheModulusOfItsMaterialAlongEveryAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    StiffnessSettings settings;
    settings.axis = axis;
    const StiffnessResult result = solved(solidBox(30, 30, 30, 0.3), settings);
    EXPECT_NEAR(result.modulus_mpa, 3861.0, 3.861e-2);
    EXPECT_NEAR(result.force_n, 3861.0 * 81.0 * 0.2 / 9.0, 0.1);
    EXPECT_NEAR(result.imbalance_n, 0.0, 1e-2);
  }
}

TEST(Stiffness, ASolidBoxSpreadsAcrossTheLoadByPoissonsRatio) {
  StiffnessSettings settings;
  settings.residual = 1e-10;
  const StiffnessResult result = solved(solidBox(20, 12, 16, 0.5), settings);
  const ElementLattice& lattice = result.model.lattice;
  const auto low = static_cast<std::size_t>(lattice.nodeAt(0, 6, 16));
  const auto high = static_cast<std::size_t>(lattice.nodeAt(20, 6, 16));
  const double strain = 0.2 / 8.0;
  EXPECT_NEAR(result.displacement.along[0][high] - result.displacement.along[0][low], 0.35 * strain * 10.0,
              1e-8);
  for (const Stress& stress : result.stress) {
    ASSERT_NEAR(stress.zz, -3861.0 * strain, 1e-3);
    ASSERT_NEAR(stress.vonMises(), 3861.0 * strain, 1e-3);
  }
}

}  // namespace
}  // namespace lamina
