// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_job.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kHeight = 0.5;
constexpr double kWidth = 1.0;

/// Lines along y side by side from x = low on, from y = 0 to 10, all in one layer after the other.
Toolpath linesFrom(double low, int lines, int layers) {
  Toolpath program;
  program.part_name = "lines";
  for (int k = 0; k < layers; ++k) {
    ToolpathLayer layer;
    layer.height_mm = kHeight;
    layer.z_mm = kHeight * (k + 1);
    for (int i = 0; i < lines; ++i) {
      Path path;
      path.role = PathRole::Infill;
      const double x = low + kWidth * (i + 0.5);
      path.points = {{x, 0.0, layer.z_mm}, {x, 10.0, layer.z_mm}};
      path.bead = beadOfArea(kWidth * kHeight, kHeight);
      path.feed_mm_s = 10.0;
      layer.paths.push_back(path);
    }
    program.layers.push_back(layer);
  }
  return program;
}

class VoidJobTest : public ::testing::Test {
 protected:
  VoidJobTest() {
    job_.part = folder_.file("box.stl");
    writeStl(job_.part, test::boxBetween({0, 0, 3}, {10, 10, 5}));
  }

  VoidReport run(const Toolpath& program) {
    NoProgress progress;
    return runVoidJob(program, job_, progress);
  }

  test::ScratchFolder folder_;
  VoidJob job_;
};

TEST_F(VoidJobTest, FindsNothingInABoxThatIsFull) {
  job_.offset = Point2(20, 0);
  const VoidReport report = run(linesFrom(20, 10, 4));
  ASSERT_EQ(report.layers.size(), 4U);
  for (const LayerVoids& layer : report.layers) {
    EXPECT_NEAR(layer.area_mm2, 100.0, 1e-6);
    EXPECT_NEAR(layer.uncovered_mm2, 0.0, 1e-6);
    EXPECT_TRUE(layer.voids.empty());
  }
}

// 10 mm that shrink by a fifth are printed 12.5 mm wide, and 2 mm that shrink by a third 3 mm high.
TEST_F(VoidJobTest, TakesAPartThatShrinksAsItIsPrinted) {
  job_.settings.compensation.shrink_xy = 0.2;
  job_.settings.compensation.shrink_z = 1.0 / 3.0;
  Toolpath program = linesFrom(0, 10, 6);
  for (ToolpathLayer& layer : program.layers)
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point.y() *= 1.25;
  job_.offset = Point2(1.25, 1.25);
  const VoidReport report = run(program);
  EXPECT_TRUE(report.part.missing.empty());
  ASSERT_EQ(report.layers.size(), 6U);
  for (const LayerVoids& layer : report.layers) EXPECT_NEAR(layer.area_mm2, 156.25, 1e-6);
}

TEST_F(VoidJobTest, FindsWhereAProgramHasPutThePart) {
  const VoidReport report = run(linesFrom(20, 10, 4));
  EXPECT_NEAR(report.part.offset.x(), 20.0, 0.02);
  EXPECT_NEAR(report.part.offset.y(), 0.0, 0.02);
}

TEST_F(VoidJobTest, FindsThePlaceOfAPartWhoseOutermostFinIsNotPrinted) {
  const Mesh fin = test::boxBetween({12, 0, 0}, {12.1, 10, 2});
  writeStl(job_.part, joined(test::boxBetween({0, 0, 0}, {10, 10, 2}), fin));
  const VoidReport report = run(linesFrom(20, 10, 4));
  EXPECT_NEAR(report.part.offset.x(), 20.0, 0.06);
  EXPECT_NEAR(report.part.offset.y(), 0.0, 0.06);
  EXPECT_NEAR(report.layers[1].uncovered_mm2, 1.0, 0.1);  // the fin
}

TEST_F(VoidJobTest, RefusesThePartOfAnotherProgram) {
  writeStl(job_.part, test::boxBetween({0, 0, 0}, {20, 10, 2}));
  try {
    run(linesFrom(20, 10, 4));
    FAIL() << "the part is twice as long";
  } catch (const InvalidInput& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("4 of 4 layers are of another size"), std::string::npos)
        << refusal.what();
  }
}

/// A plate of 30 mm whose middle 10 mm are a hole.
Mesh plateWithHole() {
  return joined(joined(test::boxBetween({0, 0, 0}, {30, 10, 2}), test::boxBetween({0, 20, 0}, {30, 30, 2})),
                joined(test::boxBetween({0, 5, 0}, {10, 25, 2}), test::boxBetween({20, 5, 0}, {30, 25, 2})));
}

/// An outer wall around a square whose middle is 15, 15.
Path wallAround(double low, double high, double z_mm) {
  Path wall;
  wall.role = PathRole::OuterWall;
  wall.is_closed = true;
  wall.points = {{low, low, z_mm}, {high, low, z_mm}, {high, high, z_mm}, {low, high, z_mm}};
  wall.bead = beadOfArea(kWidth * kHeight, kHeight);
  wall.feed_mm_s = 10.0;
  return wall;
}

/// Outer walls around these squares, given by where the lines begin and end, in each of four layers.
Toolpath wallsAround(const std::vector<std::pair<double, double>>& squares) {
  Toolpath program = linesFrom(0, 0, 4);
  for (ToolpathLayer& layer : program.layers)
    for (const auto& [low, high] : squares) layer.paths.push_back(wallAround(low, high, layer.z_mm));
  return program;
}

class OtherSectionTest : public VoidJobTest {
 protected:
  OtherSectionTest() { job_.offset = Point2::Zero(); }

  void lays(const Mesh& part) { writeStl(job_.part, part); }

  /// What the refusal says; nothing if there is none.
  std::string refusalOf(const Toolpath& program) {
    try {
      run(program);
    } catch (const InvalidInput& refusal) {
      return refusal.what();
    }
    return {};
  }
};

TEST_F(OtherSectionTest, AHoleThatThePartDoesNotHaveIsRefused) {
  const Toolpath program = wallsAround({{0.5, 29.5}, {9.5, 20.5}});
  lays(plateWithHole());
  EXPECT_EQ(refusalOf(program), "");
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  const std::string refusal = refusalOf(program);
  EXPECT_NE(refusal.find("4 of 4 layers are of another section"), std::string::npos) << refusal;
  // Lines 11 mm apart, whose beads are 1 + (1 - pi / 4) 0.5 = 1.107 mm wide.
  EXPECT_NE(refusal.find("nothing is deposited in a hole of 9.893 x 9.893 mm"), std::string::npos) << refusal;
}

TEST_F(OtherSectionTest, BeadsWhereThePartHasAHoleAreRefused) {
  Toolpath program = wallsAround({{0.5, 29.5}});
  for (ToolpathLayer& layer : program.layers) {
    Path line = linesFrom(0, 1, 1).layers[0].paths[0];
    line.points = {{1, 15, layer.z_mm}, {29, 15, layer.z_mm}};
    layer.paths.push_back(line);
  }
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  EXPECT_EQ(refusalOf(program), "");
  lays(plateWithHole());
  // Of the 10 mm over the hole, 1.5 beads at either end may be.
  const std::string refusal = refusalOf(program);
  EXPECT_NE(refusal.find("6.678 mm of beads lie 1.661 mm or more outside the part"), std::string::npos)
      << refusal;
}

TEST_F(OtherSectionTest, AHoleThroughPartOfTheLayersIsRefused) {
  // Layers of the hole, of four: two are neighbours.
  Toolpath program = wallsAround({{0.5, 29.5}, {9.5, 20.5}});
  const Toolpath full = wallsAround({{0.5, 29.5}});
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  for (const std::size_t first : {0U, 2U}) {
    Toolpath half = program;
    half.layers[first] = full.layers[first];
    half.layers[first + 1] = full.layers[first + 1];
    const std::string refusal = refusalOf(half);
    EXPECT_NE(refusal.find("2 of 4 layers are of another section"), std::string::npos) << refusal;
  }
}

TEST_F(OtherSectionTest, BeadsInAHoleOfPartOfTheLayersAreRefused) {
  Toolpath program = wallsAround({{0.5, 29.5}});
  for (ToolpathLayer& layer : program.layers) {
    Path line = linesFrom(0, 1, 1).layers[0].paths[0];
    line.points = {{1, 15, layer.z_mm}, {29, 15, layer.z_mm}};
    layer.paths.push_back(line);
  }
  const Mesh below = test::boxBetween({0, 0, -1}, {30, 30, 0});
  lays(joined(below, plateWithHole()));
  const std::string refusal = refusalOf(program);
  // The lowest two of its four layers are full.
  EXPECT_NE(refusal.find("2 of 4 layers"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("(in layer 2 6.678 mm of beads"), std::string::npos) << refusal;
}

TEST_F(OtherSectionTest, ASingleLayerOfAnotherSectionIsNamed) {
  Toolpath program = wallsAround({{0.5, 29.5}});
  const Toolpath holed = wallsAround({{0.5, 29.5}, {9.5, 20.5}});
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  EXPECT_EQ(run(program).part.other_section, "");
  program.layers[1] = holed.layers[1];
  EXPECT_EQ(run(program).part.other_section,
            "in layer 1 nothing is deposited in a hole of 9.893 x 9.893 mm, where the part has material");
  program.layers[3] = holed.layers[3];
  EXPECT_EQ(refusalOf(program), "") << "two that are no neighbours";
}

TEST_F(OtherSectionTest, AHoleThatIsFilledIsNone) {
  Toolpath program = wallsAround({{0.5, 29.5}, {9.5, 20.5}});
  for (ToolpathLayer& layer : program.layers) {
    Path line = linesFrom(0, 1, 1).layers[0].paths[0];
    line.points = {{10, 15, layer.z_mm}, {20, 15, layer.z_mm}};
    layer.paths.push_back(line);
  }
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  EXPECT_EQ(refusalOf(program), "");
}

// As programs without roles are read: every wall is an outer one.
TEST_F(OtherSectionTest, WallsSideBySideAroundAHollowPartAreNoHole) {
  lays(test::boxBetween({0, 0, 0}, {30, 30, 2}));
  EXPECT_EQ(refusalOf(wallsAround({{0.5, 29.5}, {1.5, 28.5}})), "");
}

TEST_F(VoidJobTest, FindsTheLineThatIsMissing) {
  Toolpath program = linesFrom(0, 10, 4);
  program.layers[2].paths.erase(program.layers[2].paths.begin() + 4);
  job_.offset = Point2::Zero();
  const VoidReport report = run(program);
  ASSERT_EQ(report.layers[2].voids.size(), 1U);
  // A bead reaches a little farther than it fills, from both sides.
  const double reached = (1.0 - M_PI / 4.0) * kHeight;
  EXPECT_NEAR(report.layers[2].uncovered_mm2, 10.0 * (kWidth - reached), 0.05);
  EXPECT_NEAR(report.layers[1].uncovered_mm2, 0.0, 1e-6);
}

TEST_F(VoidJobTest, TakesALayerBeyondThePartForOverfill) {
  job_.offset = Point2::Zero();
  const VoidReport report = run(linesFrom(0, 10, 5));
  EXPECT_NEAR(report.layers[4].area_mm2, 0.0, 1e-9);
  // Ten lines with round ends.
  EXPECT_NEAR(report.layers[4].overfill_mm2, 10 * kWidth * (10.0 + M_PI / 4.0 * kWidth), 0.1);
}

TEST_F(VoidJobTest, CountsLayersThatAProgramLacksAsUncovered) {
  job_.offset = Point2(20, 0);
  const VoidReport whole = run(linesFrom(20, 10, 4));
  EXPECT_TRUE(whole.part.missing.empty());
  const VoidReport half = run(linesFrom(20, 10, 2));
  ASSERT_EQ(half.part.missing.size(), 2U);
  EXPECT_NEAR(half.part.missing[1].z_mm, 2.0, 1e-9);
  const VoidTotals sums = totals(half);
  EXPECT_EQ(sums.layers, 2U);
  EXPECT_NEAR(sums.uncovered.mean_percent, 50.0, 0.01);
  EXPECT_NEAR(sums.uncovered.total_percent, 50.0, 0.01);
  EXPECT_NEAR(sums.uncovered.worst_percent, 100.0, 1e-9);
  EXPECT_NEAR(sums.runs_per_layer_mean, 10.0, 1e-9);
}

TEST_F(VoidJobTest, FindsLayersThatAreMissingBetweenOthers) {
  Toolpath program = linesFrom(20, 10, 4);
  program.layers.erase(program.layers.begin() + 1, program.layers.begin() + 3);
  EXPECT_EQ(run(program).part.missing.size(), 2U);
}

// The part begins above the raft and its gap, narrower at the top: a section that is too low is too large.
TEST_F(VoidJobTest, FindsThePartAboveItsRaft) {
  writeStl(job_.part,
           joined(test::boxBetween({-5, 0, 0}, {5, 10, 1}), test::boxBetween({-3, 0, 1}, {3, 10, 2})));
  job_.offset = Point2::Zero();
  Toolpath program = linesFrom(-5, 10, 4);
  const VoidReport plain = run(program);
  for (ToolpathLayer& layer : program.layers) {
    layer.z_mm += 1.25;
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point.z() += 1.25;
  }
  ToolpathLayer raft = linesFrom(-5, 10, 1).layers[0];
  for (Path& path : raft.paths) path.role = PathRole::Raft;
  program.layers.insert(program.layers.begin(), {raft, raft});
  program.layers[1].z_mm += kHeight;
  const VoidReport raised = run(program);
  EXPECT_EQ(raised.part.missing.size(), plain.part.missing.size());
  for (std::size_t l = 0; l < plain.layers.size(); ++l) {
    EXPECT_NEAR(raised.layers[l + 2].area_mm2, plain.layers[l].area_mm2, 1e-6);
    EXPECT_NEAR(raised.layers[l + 2].overfill_mm2, plain.layers[l].overfill_mm2, 1e-6);
  }
}

TEST_F(VoidJobTest, MissesNoLayerWhereThePartHasNoMaterial) {
  writeStl(job_.part,
           joined(test::boxBetween({0, 0, 0}, {10, 10, 0.5}), test::boxBetween({0, 0, 1.5}, {10, 10, 2})));
  Toolpath program = linesFrom(20, 10, 4);
  program.layers.erase(program.layers.begin() + 1, program.layers.begin() + 3);
  EXPECT_TRUE(run(program).part.missing.empty());
}

TEST_F(VoidJobTest, WithoutAPartTakesWhatTheOuterWallsEnclose) {
  Toolpath program = linesFrom(0, 10, 1);
  const auto loop = [&](double low, double high) {
    Path wall = program.layers[0].paths[0];
    wall.role = PathRole::OuterWall;
    wall.is_closed = true;
    wall.points = {{low, low, kHeight}, {high, low, kHeight}, {high, high, kHeight}, {low, high, kHeight}};
    return wall;
  };
  job_.part.clear();
  EXPECT_THROW(run(program), InvalidInput);
  program.layers[0].paths = {loop(20, 30), loop(24, 26)};
  const VoidReport report = run(program);
  // The walls are a little wider than they fill.
  const double reach = kWidth + (1.0 - M_PI / 4.0) * kHeight;
  EXPECT_NEAR(report.layers[0].area_mm2, std::pow(10 + reach, 2) - std::pow(2 - reach, 2), 1e-3);
  EXPECT_NEAR(report.layers[0].uncovered_mm2, std::pow(10 - reach, 2) - std::pow(2 + reach, 2), 1.0);
  EXPECT_EQ(report.layers[0].overfill_mm2, 0.0);
}

TEST_F(VoidJobTest, RefusesLayersThatDoNotRise) {
  Toolpath program = linesFrom(0, 10, 2);
  program.layers[1].z_mm = program.layers[0].z_mm;
  EXPECT_THROW(run(program), InvalidInput);
}

}  // namespace
}  // namespace lamina
