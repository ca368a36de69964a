// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/voxel_deposit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/deposition/strand.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

const Bead kBead{0.48, 0.3};
constexpr double kNoBed = -1000.0;

ToolAxisMotion strand(const Point3& start, const Point3& end, const Bead& bead = kBead) {
  ToolAxisMotion motion;
  motion.start = start;
  motion.end = end;
  motion.volume_mm3 = crossSection(bead) * (end - start).norm();
  motion.radius_mm = strandRadius(crossSection(bead));
  return motion;
}

ToolAxisMotion turned(ToolAxisMotion motion, const Eigen::Quaterniond& turn) {
  for (Eigen::Vector3d* vector : {&motion.start, &motion.end, &motion.start_tool_axis, &motion.end_tool_axis})
    *vector = turn * *vector;
  motion.start_tool_axis.normalize();
  motion.end_tool_axis.normalize();
  return motion;
}

VoxelDeposit deposit(const Point3& low, const Point3& high, double voxel_mm, double bed_z_mm = 0.0) {
  DepositionSettings settings;
  settings.bed_z_mm = bed_z_mm;
  return VoxelDeposit(voxelFrame({low, high}, voxel_mm), settings, TopHeights::Kept);
}

/// What is solid in the sheet of voxels that holds x [mm], y and z from the box's corners.
Box2 sectionBox(const VoxelGrid& grid, double x) {
  const VoxelFrame& frame = grid.frame();
  const int i = static_cast<int>(std::floor((x - frame.corner.x()) / frame.voxel_mm));
  Box2 box;
  for (int k = 0; k < frame.count[2]; ++k)
    for (int j = 0; j < frame.count[1]; ++j) {
      if (!grid.isSolid(i, j, k)) continue;
      const Point3 centre = frame.centre(i, j, k);
      const Point2 half = 0.5 * frame.voxel_mm * Point2::Ones();
      box.include(Point2(centre.y(), centre.z()) - half);
      box.include(Point2(centre.y(), centre.z()) + half);
    }
  return box;
}

/// Radius of the disc about (0, middle) which between the heights 0 and `top` has that area.
double radiusBetween(double middle, double top, double area) {
  const auto areaOf = [&](double radius) {
    constexpr int kSteps = 4000;
    double sum = 0.0;
    for (int s = 0; s < kSteps; ++s) {
      const double z = (s + 0.5) * top / kSteps - middle;
      if (std::abs(z) < radius) sum += 2.0 * std::sqrt(radius * radius - z * z) * top / kSteps;
    }
    return sum;
  };
  double low = 0.0;
  double high = 10.0;
  for (int s = 0; s < 60; ++s) (areaOf(0.5 * (low + high)) < area ? low : high) = 0.5 * (low + high);
  return low;
}

void expectBalance(const VoxelDeposit& deposit) {
  const DepositTotals totals = deposit.totals();
  EXPECT_NEAR(totals.deposited_mm3 + totals.held_mm3 + totals.excess_mm3 + totals.outside_mm3,
              totals.extruded_mm3, 1e-9 * std::max(1.0, totals.extruded_mm3));
  EXPECT_NEAR(totals.deposited_mm3, deposit.grid().solidVolume(), 1e-9 * std::max(1.0, totals.deposited_mm3));
  EXPECT_LT(totals.held_mm3, deposit.grid().frame().voxelVolume());
}

TEST(VoxelDeposit, LaysWhatIsExtrudedButForLessThanAVoxel) {
  VoxelDeposit deposited = deposit({-2, -2, 0}, {12, 2, 1}, 0.05);
  deposited.lay(strand({0, 0, 0.3}, {10, 0, 0.3}));
  EXPECT_NEAR(deposited.totals().extruded_mm3, 1.24686, 1e-5);
  EXPECT_NEAR(deposited.totals().path_mm, 10.0, 1e-12);
  EXPECT_EQ(deposited.totals().excess_mm3 + deposited.totals().outside_mm3, 0.0);
  expectBalance(deposited);
}

TEST(VoxelDeposit, ABeadOnTheBedIsADiscBetweenBedAndNozzle) {
  constexpr double kVoxelSide = 0.02;
  VoxelDeposit deposited = deposit({-1, -1, 0}, {5, 1, 1}, kVoxelSide);
  deposited.lay(strand({0, 0, 0.3}, {4, 0, 0.3}));
  const double middle = 0.3 - strandRadius(crossSection(kBead));
  const double radius = radiusBetween(middle, 0.3, crossSection(kBead));
  const Box2 section = sectionBox(deposited.grid(), 2.0);
  EXPECT_NEAR(section.size().x(), 2.0 * radius, 2.01 * kVoxelSide);
  EXPECT_NEAR(section.centre().x(), 0.0, 0.51 * kVoxelSide);
  EXPECT_NEAR(section.low.y(), 0.0, 1e-9);
  EXPECT_NEAR(section.high.y(), 0.3, 1e-9);
}

TEST(VoxelDeposit, AStrandInTheAirIsRoundAndTouchesTheNozzlesPlane) {
  constexpr double kVoxelSide = 0.02;
  VoxelDeposit deposited = deposit({-1, -1, 0}, {5, 1, 3}, kVoxelSide);
  deposited.lay(strand({0, 0, 2.0}, {4, 0, 2.0}));
  const double diameter = 2.0 * strandRadius(crossSection(kBead));
  const Box2 section = sectionBox(deposited.grid(), 2.0);
  EXPECT_NEAR(section.size().x(), diameter, 2.01 * kVoxelSide);
  EXPECT_NEAR(section.size().y(), diameter, 2.01 * kVoxelSide);
  EXPECT_LE(section.high.y(), 2.0 + 1e-9);
  EXPECT_GE(section.high.y(), 2.0 - 1.01 * kVoxelSide);
}

TEST(VoxelDeposit, MaterialSpreadsWhereStrandsCross) {  // [Vega2023, figure 29]
  constexpr double kVoxelSide = 0.025;
  constexpr int kLowerTop = 12;  // voxels: 0.3 mm
  VoxelDeposit lower = deposit({-3, -3, 0}, {3, 3, 1}, kVoxelSide);
  lower.lay(strand({0, -2, 0.3}, {0, 2, 0.3}));
  VoxelDeposit both = deposit({-3, -3, 0}, {3, 3, 1}, kVoxelSide);
  both.lay(strand({0, -2, 0.3}, {0, 2, 0.3}));
  both.lay(strand({-2, 0, 0.6}, {2, 0, 0.6}));
  expectBalance(both);
  EXPECT_EQ(both.totals().excess_mm3, 0.0);
  const double voxel_mm3 = kVoxelSide * kVoxelSide * kVoxelSide;
  EXPECT_NEAR(both.grid().solidVolume(), 8.0 * crossSection(kBead), voxel_mm3);

  const VoxelFrame& frame = both.grid().frame();
  int lost = 0;
  int widest_contact = 0;
  int width_alone = 0;
  for (int i = 0; i < frame.count[0]; ++i) {
    const double x = frame.centre(i, 0, 0).x();
    for (int k = 0; k < frame.count[2]; ++k) {
      int width = 0;
      for (int j = 0; j < frame.count[1]; ++j) {
        lost += lower.grid().isSolid(i, j, k) && !both.grid().isSolid(i, j, k) ? 1 : 0;
        width += both.grid().isSolid(i, j, k) ? 1 : 0;
      }
      // Above its top nothing is left of the lower strand.
      if (k >= kLowerTop && std::abs(x) < 0.2) widest_contact = std::max(widest_contact, width);
      if (k >= kLowerTop && std::abs(x) > 1.0) width_alone = std::max(width_alone, width);
    }
  }
  EXPECT_EQ(lost, 0);
  EXPECT_GE(widest_contact, width_alone + 2);
}

/// Every solid voxel of one, moved into the other, has a solid one at most a voxel away along each axis.
void expectCovered(const VoxelGrid& grid, const VoxelGrid& by, const Eigen::Quaterniond& turn) {
  const VoxelFrame& frame = grid.frame();
  const VoxelFrame& other = by.frame();
  std::int64_t lost = 0;
  for (int k = 0; k < frame.count[2]; ++k)
    for (int j = 0; j < frame.count[1]; ++j)
      for (int i = 0; i < frame.count[0]; ++i) {
        if (!grid.isSolid(i, j, k)) continue;
        const Point3 at = (turn * frame.centre(i, j, k) - other.corner) / other.voxel_mm;
        bool is_covered = false;
        for (int d = 0; d < 27 && !is_covered; ++d)
          is_covered = by.isSolid(static_cast<int>(std::floor(at.x())) + d % 3 - 1,
                                  static_cast<int>(std::floor(at.y())) + d / 3 % 3 - 1,
                                  static_cast<int>(std::floor(at.z())) + d / 9 - 1);
        lost += is_covered ? 0 : 1;
      }
  EXPECT_EQ(lost, 0);
}

/// Two crossing pairs of strands and a strand along which the nozzle turns, about the origin.
std::vector<ToolAxisMotion> fiveAxisMotions() {
  std::vector<ToolAxisMotion> motions{strand({-1.5, -0.2, 0.0}, {1.5, -0.2, 0.0}),
                                      strand({-1.5, 0.2, 0.0}, {1.5, 0.2, 0.0}),
                                      strand({0, -1.5, 0.3}, {0, 1.5, 0.3})};
  ToolAxisMotion turning = strand({-1.0, 1.0, 0.8}, {1.0, 1.0, 0.8});
  turning.start_tool_axis = Eigen::Vector3d(0.3, 0.0, -1.0).normalized();
  turning.end_tool_axis = Eigen::Vector3d(-0.3, 0.2, -1.0).normalized();
  motions.push_back(turning);
  return motions;
}

TEST(VoxelDeposit, AnInclinedToolAxisLaysTheSameTurned) {
  const Point3 corner(3, 3, 3);
  VoxelDeposit level = deposit(-corner, corner, 0.04, kNoBed);
  for (const ToolAxisMotion& motion : fiveAxisMotions()) level.lay(motion);
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 2, -1)}) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 4.0, axis.normalized()));
    VoxelDeposit inclined = deposit(-corner, corner, 0.04, kNoBed);
    for (const ToolAxisMotion& motion : fiveAxisMotions()) inclined.lay(turned(motion, turn));
    EXPECT_EQ(inclined.grid().solidCount(), level.grid().solidCount());
    expectCovered(level.grid(), inclined.grid(), turn);
    expectCovered(inclined.grid(), level.grid(), turn.conjugate());
  }
}

TEST(VoxelDeposit, AToolAxisUpsideDownLaysAboveItsPlane) {
  VoxelDeposit deposited = deposit({-1, -1, -1}, {5, 1, 2}, 0.05, kNoBed);
  ToolAxisMotion motion = strand({0, 0, 0.5}, {4, 0, 0.5});
  motion.start_tool_axis = motion.end_tool_axis = {0, 0, 1};
  deposited.lay(motion);
  EXPECT_NEAR(sectionBox(deposited.grid(), 2.0).low.y(), 0.5, 1e-9);
  expectBalance(deposited);
}

TEST(VoxelDeposit, ADropIsABallFlattenedByTheBed) {
  VoxelDeposit deposited = deposit({-2, -2, 0}, {2, 2, 4}, 0.04);
  ToolAxisMotion drop;
  drop.start = drop.end = {0, 0, 3.0};
  drop.volume_mm3 = 4.0 / 3.0 * M_PI * 0.125;  // radius 0.5
  deposited.lay(drop);
  const VoxelRange range = deposited.grid().solidRange();
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR((range.high[axis] - range.low[axis]) * 0.04, 1.0, 0.09);
  drop.start = drop.end = {0, 0, 0.4};
  deposited.lay(drop);
  expectBalance(deposited);
  EXPECT_EQ(deposited.grid().solidRange().low[2], 0);
  EXPECT_NEAR(deposited.grid().solidVolume(), 2.0 * drop.volume_mm3, 2e-4);
}

TEST(VoxelDeposit, TheTopIsKnownFinerThanTheVoxelsWhereTheNozzleIronedIt) {
  VoxelDeposit deposited = deposit({-1, -1, 0}, {5, 1, 2}, 0.08);
  deposited.lay(strand({0, 0, 0.3}, {4, 0, 0.3}));
  EXPECT_NEAR(deposited.surfaceHeight(2.0, 0.01), 0.3, 1e-6);
  EXPECT_NEAR(deposited.highest(), 0.3, 1e-12);
  EXPECT_EQ(deposited.surfaceHeight(2.0, 0.9), 0.0);
  EXPECT_EQ(deposited.surfaceHeight(200.0, 0.9), 0.0);
  deposited.lay(strand({0, 0, 0.57}, {4, 0, 0.57}));
  EXPECT_NEAR(deposited.surfaceHeight(2.0, 0.01), 0.57, 1e-6);
  EXPECT_NEAR(deposited.highest(), 0.57, 1e-12);
}

TEST(VoxelDeposit, NothingIsDepositedBelowTheBed) {
  VoxelDeposit deposited = deposit({-1, -1, -1}, {5, 1, 2}, 0.08, 0.1);
  deposited.lay(strand({0, 0, 0.2}, {4, 0, 0.2}));
  const VoxelFrame& frame = deposited.grid().frame();
  const int lowest = deposited.grid().solidRange().low[2];
  EXPECT_GE(frame.centre(0, 0, lowest).z(), 0.1 - 1e-6);
  EXPECT_LT(frame.centre(0, 0, lowest).z(), 0.18);
  expectBalance(deposited);
}

TEST(VoxelDeposit, WhatFindsNoRoomWithinReachIsExcess) {
  DepositionSettings settings;
  settings.reach_mm = 0.5;
  VoxelDeposit deposited(voxelFrame({Point3(-2, -2, 0), Point3(2, 2, 4)}, 0.02), settings);
  ToolAxisMotion blob;
  blob.start = blob.end = {0, 0, 2.0};
  blob.volume_mm3 = 1.0;
  blob.radius_mm = 0.2;
  deposited.lay(blob);
  // A ball of 0.5 mm without the cap of 0.3 mm that lies above the nozzle.
  const double room = 4.0 / 3.0 * M_PI * 0.125 - M_PI * 0.09 * (1.5 - 0.3) / 3.0;
  EXPECT_NEAR(deposited.totals().deposited_mm3, room, 0.02 * room);
  EXPECT_NEAR(deposited.totals().excess_mm3, 1.0 - deposited.totals().deposited_mm3, 1e-5);
  expectBalance(deposited);
  deposited.lay(blob);  // the place is full
  EXPECT_NEAR(deposited.totals().deposited_mm3, room, 0.02 * room);
  expectBalance(deposited);
  blob.start = blob.end = {0, 0, 2.1};  // room again, above
  deposited.lay(blob);
  EXPECT_GT(deposited.totals().deposited_mm3, 1.05 * room);
}

TEST(VoxelDeposit, WhatComesOutBeyondTheFrameIsOutside) {
  VoxelDeposit deposited = deposit({0, 0, 0}, {2, 2, 2}, 0.1);
  deposited.lay(strand({10, 0, 0.3}, {20, 0, 0.3}));
  EXPECT_EQ(deposited.grid().solidCount(), 0);
  EXPECT_NEAR(deposited.totals().outside_mm3, 10.0 * crossSection(kBead), 0.001);
  EXPECT_EQ(deposited.highest(), 0.0);
  expectBalance(deposited);
}

TEST(VoxelDeposit, RefusesWhatCannotBeDeposited) {
  VoxelDeposit deposited = deposit({0, 0, 0}, {2, 2, 2}, 0.1);
  ToolAxisMotion motion = strand({0, 0, 0.3}, {1, 0, 0.3});
  const auto refused = [&](auto change) {
    ToolAxisMotion wrong = motion;
    change(wrong);
    EXPECT_THROW(deposited.lay(wrong), InvalidInput);
  };
  refused([](ToolAxisMotion& m) { m.end.x() = NAN; });
  refused([](ToolAxisMotion& m) { m.end.x() = 2e6; });
  refused([](ToolAxisMotion& m) { m.volume_mm3 = -1.0; });
  refused([](ToolAxisMotion& m) { m.radius_mm = 21.0; });
  refused([](ToolAxisMotion& m) { m.end_tool_axis = {0, 0, -2}; });
  EXPECT_EQ(deposited.totals().extruded_mm3, 0.0);
  DepositionSettings far;
  far.reach_mm = 1000.0;
  EXPECT_THROW(VoxelDeposit(voxelFrame({Point3(0, 0, 0), Point3(1, 1, 1)}, 0.001), far), InvalidInput);
}

/// Motions anywhere in and around a box of 4 mm, the tool axis up to 60 degrees from the vertical.
std::vector<ToolAxisMotion> anyMotions(std::uint64_t seed) {
  Random random(seed);
  std::vector<ToolAxisMotion> motions;
  for (int m = 0; m < 12; ++m) {
    const auto point = [&] {
      return Point3(random.uniform(-1, 5), random.uniform(-1, 5), random.uniform(0, 3));
    };
    const auto tool_axis = [&] {
      return Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), -1.0).normalized();
    };
    ToolAxisMotion motion{point(), point(), tool_axis(), tool_axis(), 0.0, 0.0};
    if (m % 4 == 0) motion.end = motion.start;
    if (m % 3 == 0) motion.start_tool_axis = motion.end_tool_axis = {0, 0, -1};
    motion.volume_mm3 = random.uniform(0.0, 0.6);
    motions.push_back(motion);
  }
  return motions;
}

TEST(VoxelDeposit, NoMaterialIsLostWhateverTheMotions) {
  EXPECT_TRUE(rc::check([] {
    DepositionSettings settings;
    settings.reach_mm = *rc::gen::element(0.3, 1.0, 10.0);
    const double voxel_mm = *rc::gen::element(0.08, 0.1, 0.17);
    VoxelDeposit deposited(voxelFrame({Point3(0, 0, 0), Point3(4, 4, 3)}, voxel_mm), settings);
    VoxelDeposit again(voxelFrame({Point3(0, 0, 0), Point3(4, 4, 3)}, voxel_mm), settings);
    const auto motions = anyMotions(*rc::gen::arbitrary<std::uint32_t>());
    std::int64_t solid = 0;
    for (const ToolAxisMotion& motion : motions) {
      deposited.lay(motion);
      again.lay(motion);
      RC_ASSERT(deposited.grid().solidCount() >= solid);
      solid = deposited.grid().solidCount();
    }
    expectBalance(deposited);
    RC_ASSERT(again.grid().solidCount() == solid);
  }));
}

}  // namespace
}  // namespace lamina
