// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/pores/pore_projection.hpp"
#include "lamina/pores/pore_report.hpp"
#include "lamina/pores/voxel_surface.hpp"
#include "lamina/scaffold/scaffold.hpp"

namespace lamina {
namespace {

/// A row of [Vega2023, table 29]; `bench/measure_scaffolds` compares all of them.
struct PublishedScaffold {
  double amplitude_mm, layer_height_mm;
  int cycles, filaments;
  ScaffoldWave wave;
  double pore_um, surface_mm2, cvi_2_percent, porosity_percent;
};

class PublishedScaffoldTest : public testing::TestWithParam<PublishedScaffold> {};

TEST_P(PublishedScaffoldTest, HasThePublishedPores) {
  const PublishedScaffold& published = GetParam();
  ScaffoldSettings settings = scaffoldDefaults("sinusoidal");
  settings.amplitude_mm = published.amplitude_mm;
  settings.layer_height_mm = published.layer_height_mm;
  settings.cycles = published.cycles;
  settings.filaments = published.filaments;
  settings.wave = published.wave;
  DepositionSettings deposition;
  deposition.voxel_mm = 0.05;
  NoProgress nobody;
  const ToolpathDeposit deposited = depositedVoxels(makeScaffold("sinusoidal", settings), deposition, nobody);
  const VoxelGrid solid = cropped(deposited.grid, deposited.grid.solidRange());
  const PoreReport pores = reportPores(solid, nobody);
  EXPECT_NEAR(pores.porosity_percent, published.porosity_percent, 1.2);
  EXPECT_NEAR(pores.joining_two.volume_percent, published.cvi_2_percent, 1.2);
  EXPECT_LE(pores.joining_two.volume_percent, pores.porosity_percent);
  EXPECT_NEAR(voxelFaceArea(solid), published.surface_mm2, 0.12 * published.surface_mm2);
  EXPECT_NEAR(projectPores(solid).meanDiameterUm(), published.pore_um, 0.16 * published.pore_um);
}

INSTANTIATE_TEST_SUITE_P(
    Table29, PublishedScaffoldTest,
    testing::Values(PublishedScaffold{0.5, 0.3, 5, 5, ScaffoldWave::Cosine, 352.9, 3227.82, 70.58, 70.59},
                    PublishedScaffold{0.5, 0.15, 5, 9, ScaffoldWave::Sine, 245.09, 6023.88, 45.44, 45.47},
                    PublishedScaffold{0.1, 0.3, 9, 9, ScaffoldWave::SineCosine, 564.31, 3401.87, 62.39,
                                      62.39},
                    PublishedScaffold{0.1, 0.15, 5, 5, ScaffoldWave::Sine, 2101.4, 2847.43, 79.69, 79.69}));

}  // namespace
}  // namespace lamina
