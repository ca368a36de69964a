// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/toolpath_deposit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

/// Where a block stands and what it is deposited with.
struct Block {
  double side_mm = 10.0;
  Bead bead{0.48, 0.3};
  double first_mm = 0.3;
  int layers = 33;
};

Path line(const Point3& start, const Point3& end, const Bead& bead) {
  Path path;
  path.points = {start, end};
  path.orientation = nozzleDown();
  path.bead = bead;
  return path;
}

/// Solid layers of lines, along x and along y in turn.
Toolpath blockOf(const Block& block) {
  Toolpath toolpath;
  toolpath.part_name = "block";
  const double half = 0.5 * block.bead.width_mm;
  for (int l = 0; l < block.layers; ++l) {
    ToolpathLayer layer;
    layer.height_mm = l == 0 ? block.first_mm : block.bead.height_mm;
    layer.z_mm = block.first_mm + l * block.bead.height_mm;
    const Bead bead{block.bead.width_mm, layer.height_mm};
    const int lines = static_cast<int>(block.side_mm / planWidth(bead));
    for (int i = 0; i < lines; ++i) {
      const double across = (i + 0.5) * block.side_mm / lines;
      Point3 start(half, across, layer.z_mm);
      Point3 end(block.side_mm - half, across, layer.z_mm);
      if (l % 2 == 1) {
        std::swap(start.x(), start.y());
        std::swap(end.x(), end.y());
      }
      layer.paths.push_back(line(start, end, bead));
    }
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

DepositionSettings voxels(double voxel_mm) {
  DepositionSettings settings;
  settings.voxel_mm = voxel_mm;
  return settings;
}

ToolpathDeposit deposited(const Toolpath& toolpath, const DepositionSettings& settings) {
  NoProgress progress;
  return depositedVoxels(toolpath, settings, progress);
}

bool isSame(const VoxelGrid& a, const VoxelGrid& b) {
  if (!(a.frame() == b.frame())) return false;
  for (int k = 0; k < a.frame().count[2]; ++k)
    for (int j = 0; j < a.frame().count[1]; ++j)
      for (int w = 0; w < a.wordCount(); ++w)
        if (a.word(w, j, k) != b.word(w, j, k)) return false;
  return true;
}

TEST(ToolpathDeposit, ModelsHoldWhatIsExtrudedInBlocks) {  // within 0.01 %
  for (const Bead& bead : {Bead{0.48, 0.3}, Bead{0.4, 0.15}, Bead{0.8, 0.4}, Bead{1.2, 0.25}})
    for (const double voxel_mm : {0.1, 0.15, 0.2}) {
      const Block block{10.0, bead, bead.height_mm, static_cast<int>(10.0 / bead.height_mm)};
      const Toolpath toolpath = blockOf(block);
      const ToolpathDeposit deposit = deposited(toolpath, voxels(voxel_mm));
      const double extruded = totals(toolpath).deposited_mm3;
      EXPECT_NEAR(deposit.totals.extruded_mm3, extruded, 1e-9 * extruded);
      EXPECT_NEAR(deposit.grid.solidVolume(), extruded, 1e-4 * extruded) << bead.width_mm << ' ' << voxel_mm;
      EXPECT_EQ(deposit.totals.excess_mm3, 0.0);
      EXPECT_EQ(deposit.totals.outside_mm3, 0.0);
      EXPECT_NEAR(deposit.totals.path_mm, totals(toolpath).deposition_mm, 1e-6);
    }
}

TEST(ToolpathDeposit, ModelsAreAsHighAsTheNozzleWas) {  // [Vega2023, table 10]
  struct Case {
    Block block;
    double height_mm;
  };
  for (const Case& expected :
       {Case{{2.0, {0.48, 0.3}, 0.35, 23}, 6.95}, Case{{2.0, {0.48, 0.3}, 0.3, 7}, 2.1},
        Case{{2.0, {0.48, 0.15}, 0.15, 13}, 1.95}})
    for (const double voxel_mm : {0.05, 0.1}) {
      const ToolpathDeposit deposit = deposited(blockOf(expected.block), voxels(voxel_mm));
      EXPECT_NEAR(deposit.highest_mm, expected.height_mm, 1e-9);
      const VoxelRange range = deposit.grid.solidRange();
      EXPECT_NEAR((range.high[2] - range.low[2]) * voxel_mm, expected.height_mm, 0.501 * voxel_mm);
    }
}

TEST(ToolpathDeposit, MotionByMotionIsTheSameAsAtOnceWhateverTheThreads) {
  const Toolpath toolpath = blockOf({3.0, {0.48, 0.3}, 0.3, 5});
  const DepositionSettings settings = voxels(0.1);
  const ToolpathDeposit deposit = deposited(toolpath, settings);
  VoxelDeposit behind(deposit.grid.frame(), settings, TopHeights::Kept);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (const ToolAxisMotion& motion : toolAxisMotions(path)) behind.lay(motion);
  EXPECT_TRUE(isSame(behind.grid(), deposit.grid));
  const ThreadLimit one(1);
  EXPECT_TRUE(isSame(deposited(toolpath, settings).grid, deposit.grid));
}

TEST(ToolpathDeposit, BeadsMayVaryAlongThePath) {
  Toolpath toolpath;
  ToolpathLayer layer;
  layer.z_mm = layer.height_mm = 0.3;
  Path path = line({0, 0, 0.3}, {5, 0, 0.3}, {});
  path.points.emplace_back(10, 0, 0.3);
  path.bead = AlongPath<Bead>({{}, {0.48, 0.3}, {0.96, 0.3}});
  layer.paths.push_back(path);
  toolpath.layers.push_back(layer);
  const ToolpathDeposit deposit = deposited(toolpath, voxels(0.04));
  const VoxelFrame& frame = deposit.grid.frame();
  const auto widthAt = [&](double x) {
    const int i = static_cast<int>(std::floor((x - frame.corner.x()) / frame.voxel_mm));
    int width = 0;
    for (int j = 0; j < frame.count[1]; ++j) width += deposit.grid.isSolid(i, j, 3) ? 1 : 0;
    return width * frame.voxel_mm;
  };
  EXPECT_NEAR(widthAt(2.5), 0.48, 0.1);
  EXPECT_NEAR(widthAt(7.5), 0.96, 0.15);
  EXPECT_NEAR(deposit.grid.solidVolume(), depositedVolume(path), frame.voxelVolume());
}

TEST(ToolpathDeposit, DropsAreDepositedAtTheirWaypoints) {
  Toolpath toolpath;
  ToolpathLayer layer;
  layer.z_mm = layer.height_mm = 0.4;
  Path path = line({0, 0, 0.4}, {3, 0, 0.4}, {0.8, 0.4});
  path.deposit = Deposit::Drops;
  layer.paths.push_back(path);
  toolpath.layers.push_back(layer);
  const ToolpathDeposit deposit = deposited(toolpath, voxels(0.05));
  EXPECT_NEAR(deposit.totals.extruded_mm3, 2.0 * 0.25 * M_PI * 0.64 * 0.4, 1e-9);
  EXPECT_NEAR(deposit.grid.solidVolume(), deposit.totals.extruded_mm3,
              1.01 * deposit.grid.frame().voxelVolume());
  const VoxelFrame& frame = deposit.grid.frame();
  const auto indexOf = [&](double x) {
    return static_cast<int>(std::floor((x - frame.corner.x()) / frame.voxel_mm));
  };
  const int j = static_cast<int>(std::floor((0.01 - frame.corner.y()) / frame.voxel_mm));
  EXPECT_TRUE(deposit.grid.isSolid(indexOf(0.01), j, 2));
  EXPECT_TRUE(deposit.grid.isSolid(indexOf(3.01), j, 2));
  EXPECT_FALSE(deposit.grid.isSolid(indexOf(1.5), j, 2));
}

TEST(ToolpathDeposit, TravelsLayNothingAndSkirtsOnlyIfAsked) {
  Toolpath toolpath = blockOf({3.0, {0.48, 0.3}, 0.3, 1});
  const double part = totals(toolpath).deposited_mm3;
  Path skirt = line({-3, -3, 0.3}, {6, -3, 0.3}, {0.48, 0.3});
  skirt.role = PathRole::Skirt;
  Path travel = skirt;
  travel.role = PathRole::Travel;
  toolpath.layers[0].paths.push_back(skirt);
  toolpath.layers[0].paths.push_back(travel);
  EXPECT_NEAR(deposited(toolpath, voxels(0.1)).totals.extruded_mm3, part, 1e-9);
  DepositionSettings with_skirt = voxels(0.1);
  with_skirt.are_build_aids_deposited = true;
  EXPECT_NEAR(deposited(toolpath, with_skirt).totals.extruded_mm3, part + depositedVolume(skirt), 1e-9);
  EXPECT_THROW(deposited(Toolpath(), voxels(0.1)), InvalidInput);
}

TEST(ToolpathDeposit, AGridTooLargeIsRefusedWithTheVoxelThatFits) {
  const Toolpath toolpath = blockOf({10.0, {0.48, 0.3}, 0.3, 10});
  DepositionSettings settings = voxels(0.02);
  settings.memory_limit_mb = 0.1;
  std::string message;
  try {
    deposited(toolpath, settings);
  } catch (const InvalidInput& error) {
    message = error.what();
  }
  const std::string before = "voxels of ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  settings.voxel_mm = std::stod(message.substr(at + before.size()));
  EXPECT_GT(settings.voxel_mm, 0.02);
  const ToolpathDeposit deposit = deposited(toolpath, settings);
  EXPECT_LE(deposit.grid.bytes(), 100000U);
  settings.voxel_mm *= 0.8;
  EXPECT_THROW(deposited(toolpath, settings), InvalidInput);
  settings.voxel_mm = 0.001;  // too many bricks even to be counted
  EXPECT_THROW(deposited(toolpath, settings), InvalidInput);
}

TEST(ToolpathDeposit, MemoryIsPredictedAndSmall) {
  const Toolpath toolpath = blockOf({10.0, {0.48, 0.3}, 0.3, 33});
  for (const double voxel_mm : {0.05, 0.1}) {
    const ToolpathDeposit deposit = deposited(toolpath, voxels(voxel_mm));
    const double bytes = static_cast<double>(deposit.grid.bytes());
    EXPECT_GE(depositBytes(toolpath, voxels(voxel_mm)), 0.95 * bytes);
    EXPECT_LE(depositBytes(toolpath, voxels(voxel_mm)), 1.4 * bytes);
    EXPECT_LE(8.0 * bytes, 2.0 * static_cast<double>(deposit.grid.solidCount()));
  }
}

TEST(ToolpathDeposit, CanBeCancelled) {
  class Cancel final : public Progress {
   public:
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  };
  Cancel progress;
  EXPECT_THROW(depositedVoxels(blockOf({3.0, {0.48, 0.3}, 0.3, 1}), voxels(0.1), progress), Cancelled);
}

}  // namespace
}  // namespace lamina
