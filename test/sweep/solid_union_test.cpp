// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/sweep/solid_union.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/mesh/mesh_report.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/scaffold/scaffold.hpp"
#include "support/scratch_folder.hpp"
#include "sweep/specimen.hpp"

namespace lamina {
namespace {

constexpr CornerStrategy kStrategies[] = {CornerStrategy::Whole, CornerStrategy::Lines,
                                          CornerStrategy::Revolved, CornerStrategy::Sections};

std::vector<BeadSolid> solidsOf(const Toolpath& toolpath, CornerStrategy corners) {
  SweepSettings settings;
  settings.corners = corners;
  return beadSolids(sweepsOf(toolpath, settings), corners);
}

double volumeOf(const Toolpath& toolpath, CornerStrategy corners) {
  NoProgress progress;
  return unionVolume(solidsOf(toolpath, corners), progress);
}

Mesh surfaceOf(const std::vector<BeadSolid>& solids, double voxel_mm) {
  NoProgress progress;
  return unionSurface(solids, voxelUnion(solids, voxel_mm, progress));
}

Toolpath single(const std::vector<Point3>& points, const Bead& bead) {
  Toolpath toolpath;
  toolpath.layers = {{bead.height_mm, bead.height_mm, {test::bead(points, bead)}}};
  return toolpath;
}

TEST(SolidUnion, StraightSweepIsSectionTimesLength) {
  for (int half_degrees = 0; half_degrees < 360; ++half_degrees) {
    const double angle = half_degrees * M_PI / 360.0;
    const Point3 end(10 * std::cos(angle), 10 * std::sin(angle), 0.3);
    const Toolpath toolpath = single({{0, 0, 0.3}, end}, {0.48, 0.3});
    EXPECT_NEAR(volumeOf(toolpath, CornerStrategy::Sections), 1.24686, 1e-4 * 1.24686) << angle;
  }
  EXPECT_NEAR(volumeOf(single({{0, 0, 0.6}, {10, 0, 0.6}}, {0.3, 0.6}), CornerStrategy::Whole),
              10 * crossSection({0.3, 0.6}), 5e-3 * 1.6);
}

TEST(SolidUnion, BoxOfAStraightSweepIsTight) {
  const Box3 box =
      unionBox(solidsOf(single({{0, 0, 0.3}, {10, 0, 0.3}}, {0.48, 0.3}), CornerStrategy::Whole));
  EXPECT_LT((box.low - Point3(0, -0.24, 0)).norm(), 1e-12);
  EXPECT_LT((box.high - Point3(10, 0.24, 0.3)).norm(), 1e-12);
}

TEST(SolidUnion, MitredRingHasTheVolumeOfItsMiddleLine) {
  const Toolpath toolpath = test::layered({0.3}, [](std::size_t, double z, double h) {
    return std::vector<Path>{test::ring({{2, 2, z}, {12, 2, z}, {12, 6.5, z}, {5, 9, z}}, {0.48, h})};
  });
  const double swept = totals(toolpath).deposited_mm3;
  EXPECT_NEAR(volumeOf(toolpath, CornerStrategy::Whole), swept, 2e-4 * swept);
  // Flat ends leave a notch at each corner and overlap inside.
  EXPECT_LT(volumeOf(toolpath, CornerStrategy::Lines), 0.999 * swept);
  EXPECT_GT(volumeOf(toolpath, CornerStrategy::Revolved), volumeOf(toolpath, CornerStrategy::Lines));
}

TEST(SolidUnion, RevolvedCornerFillsTheNotchRoundly) {
  // At a right angle the profile revolved fills a quarter of the notch's ring: by Pappus, less what overlaps.
  const Toolpath toolpath = single({{0, 0, 0.3}, {10, 0, 0.3}, {10, 10, 0.3}}, {0.48, 0.3});
  const double lines = volumeOf(toolpath, CornerStrategy::Lines);
  // Half profile: rectangle 0.09 x 0.3 and half disc of radius 0.15; a quarter turn about its inner edge.
  const double moment = 0.09 * 0.3 * 0.045 + 0.5 * M_PI * 0.0225 * (0.09 + 4 * 0.15 / (3 * M_PI));
  EXPECT_NEAR(volumeOf(toolpath, CornerStrategy::Revolved) - lines, 0.5 * M_PI * moment, 0.02 * moment);
}

TEST(SolidUnion, LayersThatMeetAreCountedOnce) {
  const auto two = [](std::size_t, double z, double h) {
    return std::vector<Path>{test::bead({{0, 0, z}, {10, 0, z}}, {0.48, h}),
                             test::bead({{0, 0.2, z}, {10, 0.2, z}}, {0.48, h})};
  };
  const double one_layer = volumeOf(test::layered({0.3}, two), CornerStrategy::Whole);
  EXPECT_NEAR(volumeOf(test::layered({0.3, 0.6, 0.9}, two), CornerStrategy::Whole), 3 * one_layer, 1e-4);
  // What both share is the lens between round sides of radius 0.15, their middles 0.2 - 0.18 apart.
  const double apart = 0.02,
               lens = 0.045 * std::acos(apart / 0.3) - 0.5 * apart * std::sqrt(0.09 - apart * apart);
  EXPECT_NEAR(one_layer, 2 * 1.24686 - 10 * lens, 1e-3);
}

TEST(SolidUnion, HeightsAreThoseOfTheLayers) {
  EXPECT_NEAR(unionBox(solidsOf(test::cylinder(0.5), CornerStrategy::Sections)).size().z(), 6.95, 1e-9);
  EXPECT_NEAR(
      unionBox(solidsOf(test::concentricSpecimen(7, 0.3, 0.4968), CornerStrategy::Sections)).size().z(), 2.1,
      1e-9);
  EXPECT_NEAR(
      unionBox(solidsOf(test::concentricSpecimen(13, 0.15, 0.48), CornerStrategy::Sections)).size().z(), 1.95,
      1e-9);
}

TEST(SolidUnion, SolidSpecimenHasTheMassOfTheTable) {
  constexpr double kPla = 1.24e-3;  // g/mm3
  EXPECT_NEAR(kPla * volumeOf(test::concentricSpecimen(7, 0.3, 0.4968), CornerStrategy::Sections), 0.451,
              0.03 * 0.451);
  EXPECT_NEAR(kPla * volumeOf(test::concentricSpecimen(13, 0.15, 0.4968), CornerStrategy::Sections), 0.451,
              0.03 * 0.451);
}

TEST(SolidUnion, CylindersAreWhatIsExtrudedWithinOneInFiveHundred) {
  const auto deviation = [](double density) {
    ScaffoldSettings settings = scaffoldDefaults("cylinder");
    settings.density = density;
    const Toolpath toolpath = makeScaffold("cylinder", settings);
    return volumeOf(toolpath, CornerStrategy::Sections) / totals(toolpath).deposited_mm3 - 1.0;
  };
  EXPECT_NEAR(deviation(0.5), 0.0, 2e-3);
  EXPECT_NEAR(deviation(0.4), 0.0, 2e-3);
}

TEST(SolidUnion, VolumeDoesNotDependOnWhereThePartStands) {
  EXPECT_TRUE(rc::check("the union turned and moved has the same volume", [] {
    const double angle = *rc::gen::inRange(0, 360) * M_PI / 180,
                 shift = *rc::gen::inRange(-1000, 1000) * 0.01;
    std::vector<Point3> points;
    for (int i = 0; i < 5; ++i)
      points.emplace_back(*rc::gen::inRange(0, 100) * 0.1, *rc::gen::inRange(0, 100) * 0.1, 0.3);
    std::vector<Point3> moved;
    for (const Point3& p : points)
      moved.push_back(Eigen::AngleAxisd(angle, Point3::UnitZ()) * p + Point3(shift, 2 * shift, 0));
    for (const CornerStrategy corners : kStrategies) {
      const double one = volumeOf(single(points, {0.48, 0.3}), corners);
      RC_ASSERT(std::abs(volumeOf(single(moved, {0.48, 0.3}), corners) - one) <= 2e-3 * one + 1e-3);
    }
  }));
}

TEST(SolidUnion, SurfaceIsClosedAndHoldsTheVolume) {
  NoProgress progress;
  const Toolpath toolpath = test::concentricSpecimen(2, 0.3, 0.48);
  for (const CornerStrategy corners : kStrategies) {
    const std::vector<BeadSolid> solids = solidsOf(toolpath, corners);
    const Mesh mesh = surfaceOf(solids, 0.1);
    const MeshReport report = reportMesh(mesh, progress);
    EXPECT_TRUE(report.is_closed) << toString(corners);
    EXPECT_EQ(report.nonmanifold_edges, 0U) << toString(corners);
    EXPECT_NEAR(report.volume_mm3, unionVolume(solids, progress), 0.03 * report.volume_mm3)
        << toString(corners);
  }
}

TEST(SolidUnion, SurfaceStaysClosedInAFile) {
  NoProgress progress;
  const test::ScratchFolder folder;
  // Bottoms and sides that lie on lattice points.
  const Toolpath toolpath = test::layered({0.25, 0.55}, [](std::size_t, double z, double h) {
    return std::vector<Path>{test::bead({{90.05, 90.25, z}, {94.05, 90.25, z}, {94.05, 93, z}}, {0.4, h})};
  });
  const std::string path = folder.file("union.stl");
  writeStl(path, surfaceOf(solidsOf(toolpath, CornerStrategy::Whole), 0.1));
  const MeshReport report = reportMesh(readMesh(path, {}), progress);
  EXPECT_TRUE(report.is_closed);
  EXPECT_EQ(report.nonmanifold_edges, 0U);
  EXPECT_EQ(report.degenerate_triangles, 0U);
}

TEST(SolidUnion, FinerLatticeComesNearerTheVolume) {
  NoProgress progress;
  const std::vector<BeadSolid> solids =
      solidsOf(single({{0, 0, 0.3}, {5, 1, 0.3}, {5, 4, 0.3}}, {0.48, 0.3}), CornerStrategy::Whole);
  const double exact = unionVolume(solids, progress);
  const double coarse = std::abs(volume(surfaceOf(solids, 0.08)) - exact);
  const double fine = std::abs(volume(surfaceOf(solids, 0.02)) - exact);
  EXPECT_LT(fine, 0.25 * coarse);
  EXPECT_LT(fine, 0.003 * exact);
}

TEST(SolidUnion, NozzleMayTilt) {
  Toolpath toolpath = single({{0, 0, 0.3}, {10, 0, 0.3}, {10, 8, 0.3}}, {0.48, 0.3});
  const double level = volumeOf(toolpath, CornerStrategy::Revolved);
  const Eigen::AngleAxisd tilt(0.6, Point3(1, 2, 0).normalized());
  for (Point3& point : toolpath.layers[0].paths[0].points) point = tilt * point;
  toolpath.layers[0].paths[0].orientation = Eigen::Quaterniond(tilt) * nozzleDown();
  EXPECT_NEAR(volumeOf(toolpath, CornerStrategy::Revolved), level, 0.005 * level);
}

}  // namespace
}  // namespace lamina
