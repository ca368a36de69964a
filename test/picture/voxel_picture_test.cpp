// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/voxel_picture.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/png_image.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// 20 x 10 x 6 voxels, and of these those from 8 to 12 along x open in the upper half.
VoxelGrid slottedBlock(double voxel_mm) {
  VoxelGrid grid({Point3(5, 5, 0), voxel_mm, {40, 30, 10}});
  for (int k = 0; k < 6; ++k)
    for (int j = 10; j < 20; ++j)
      for (int i = 10; i < 30; ++i)
        if (k < 3 || i < 18 || i >= 22) grid.fill(i, j, k);
  return grid;
}

/// Share of the pixels between title and scale bar that are dark, of those dark or light grey.
double darkShare(const std::string& path) {
  const test::PngImage image(path);
  int dark = 0;
  int light = 0;
  for (int row = 90; row < image.height() - 60; ++row)
    for (int column = 0; column < image.width(); ++column) {
      const double red = image.at(column, row).red;
      dark += red < 0.4 ? 1 : 0;
      light += red >= 0.4 && red < 0.97 ? 1 : 0;
    }
  return double(dark) / (dark + light);
}

TEST(VoxelPicture, ShowsTheVoxelsOfASheet) {
  const test::ScratchFolder folder;
  const VoxelGrid grid = slottedBlock(0.5);
  const auto shareAt = [&](std::size_t axis, double at_mm) {
    drawVoxelSheet(folder.file("a.png"), grid, sheetAt(grid.frame(), axis, at_mm), {"Block", "a test"});
    return darkShare(folder.file("a.png"));
  };
  // Around what is solid four voxels are shown.
  EXPECT_NEAR(shareAt(2, 0.6), 200.0 / (28.0 * 18.0), 0.01);
  EXPECT_NEAR(shareAt(2, 2.6), 160.0 / (28.0 * 18.0), 0.01);
  EXPECT_NEAR(shareAt(2, 4.6), 0.0, 1e-9);
  EXPECT_NEAR(shareAt(1, 12.0), (120.0 - 12.0) / (28.0 * 14.0), 0.01);
  EXPECT_NEAR(shareAt(0, 15.1), 30.0 / (18.0 * 14.0), 0.01);
}

TEST(VoxelPicture, RefusesPlacesBeyondTheVoxelsAndNothingToSee) {
  const test::ScratchFolder folder;
  const VoxelGrid grid = slottedBlock(0.5);
  EXPECT_THROW(sheetAt(grid.frame(), 0, 4.9), InvalidInput);
  EXPECT_THROW(sheetAt(grid.frame(), 2, 5.1), InvalidInput);
  EXPECT_EQ(sheetAt(grid.frame(), 2, 4.99).index, 9);
  EXPECT_THROW(drawVoxelSheet(folder.file("a.png"), VoxelGrid(grid.frame()), {}, {"", ""}), InvalidInput);
}

}  // namespace
}  // namespace lamina
