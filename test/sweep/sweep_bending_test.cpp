// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/scaffold/scaffold.hpp"
#include "lamina/stiffness/stiffness.hpp"
#include "lamina/sweep/solid_union.hpp"

namespace lamina {
namespace {

/// Force on the punch of the first bending specimen of [Vega2023, table 13], swept with these corners.
double bendingForce(const Toolpath& specimen, CornerStrategy corners) {
  NoProgress progress;
  SweepSettings sweep;
  sweep.corners = corners;
  const std::vector<BeadSolid> solids = beadSolids(sweepsOf(specimen, sweep), corners);
  StiffnessSettings stiffness;
  stiffness.load = Load::Bending;
  return solveStiffness(voxelUnion(solids, 0.1, progress), stiffness, progress).force_n;
}

TEST(SweepBending, CornersMakeNoDifferenceToTheFirstSpecimen) {
  const Toolpath specimen = makeScaffold("bending_specimen", scaffoldDefaults("bending_specimen"));
  std::vector<double> forces_n;
  for (const CornerStrategy corners :
       {CornerStrategy::Whole, CornerStrategy::Lines, CornerStrategy::Revolved, CornerStrategy::Sections})
    forces_n.push_back(bendingForce(specimen, corners));
  const auto [least, greatest] = std::minmax_element(forces_n.begin(), forces_n.end());
  EXPECT_LT(*greatest / *least - 1.0, 0.005);
  // [Vega2023, table 2]: 13.47 to 13.49 N.
  EXPECT_NEAR(forces_n.back(), 13.49, 0.1 * 13.49);
}

}  // namespace
}  // namespace lamina
