// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/plate/laid_beside.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/job/plate/plate_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// A pitch of 0.4 x 0.2 mm beads is 0.357080 mm: 8 mm are 22 of them, 7.855760 mm.
constexpr double kBrim = 7.85576;
const Box2 kWide{{-100, -100}, {100, 100}};

class LaidBesideTest : public ::testing::Test {
 protected:
  LaidBesideTest() {
    job_.settings.planning.skirt.count = 0;
    job_.settings.planning.infill.density = 0.0;
  }

  void addBox(const std::string& name, const Point3& size, const std::optional<Point2>& at = std::nullopt) {
    const std::string path = folder_.file(name + ".stl");
    writeStl(path, test::boxBetween(Point3::Zero(), size));
    job_.plate.parts.emplace_back();
    job_.plate.parts.back().file = path;
    job_.plate.parts.back().at_mm = at;
  }

  std::string refusal() {
    NoProgress nobody;
    try {
      runPlateJob(job_, nobody);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  /// Free ways between boxes of that width, along x or y.
  double gap(double width_mm = 20.0) {
    NoProgress nobody;
    const SlicedPlate plate = runPlateJob(job_, nobody);
    const Point2 apart = (plate.parts[1].at_mm - plate.parts[0].at_mm).cwiseAbs();
    return apart.maxCoeff() - width_mm;
  }

  test::ScratchFolder folder_;
  PlateJob job_;
};

TEST_F(LaidBesideTest, CoversWhatBrimsAndRaftsDo) {
  NoProgress nobody;
  const Mesh cube = test::boxBetween({-10, -10, 0}, {10, 10, 2});
  EXPECT_TRUE(laidBeside(cube, job_.settings, kWide, nobody).empty());
  EXPECT_EQ(reachBeside(job_.settings), 0.0);
  job_.settings.planning.adhesion.brim.width_mm = 8.0;
  const double side_mm = 20.0 + 2.0 * kBrim;
  EXPECT_NEAR(reachBeside(job_.settings), kBrim, 1e-5);
  EXPECT_NEAR(area(laidBeside(cube, job_.settings, kWide, nobody)), side_mm * side_mm - 400.0, 0.01);
  job_.settings.planning.adhesion.brim.where = BrimWhere::Inside;
  EXPECT_EQ(reachBeside(job_.settings), 0.0);
  EXPECT_TRUE(laidBeside(cube, job_.settings, kWide, nobody).empty()) << "it has no hole";
  job_.settings.planning.adhesion.raft.layers = 2;
  EXPECT_EQ(reachBeside(job_.settings), 3.0);
  EXPECT_NEAR(area(laidBeside(cube, job_.settings, kWide, nobody)), 26.0 * 26.0, 1e-3);
}

/// 5 mm of the 7.86 are on the bed, on one side.
TEST_F(LaidBesideTest, EndsAtTheEdgeOfTheBed) {
  NoProgress nobody;
  const Mesh cube = test::boxBetween({-10, -10, 0}, {10, 10, 2});
  const Box2 bed{{-15, -100}, {100, 100}};
  job_.settings.planning.adhesion.brim.width_mm = 8.0;
  const double side_mm = 20.0 + 2.0 * kBrim;
  EXPECT_NEAR(area(laidBeside(cube, job_.settings, bed, nobody)), side_mm * (side_mm - (kBrim - 5.0)) - 400.0,
              0.01);
  EXPECT_NEAR(cutAtEdge(job_.settings), kBrim, 1e-5);
  job_.settings.planning.adhesion.raft.layers = 2;
  EXPECT_EQ(cutAtEdge(job_.settings), 0.0);
}

/// Boxes of 100 mm with brims of 7.86 mm and 5 mm between these take 236.4 mm of the 220 mm in a row, of
/// which the outer brims need not be on the bed: 220.7 mm. With 4 mm between them there is room.
TEST_F(LaidBesideTest, TakesNoRoomBeyondTheBed) {
  addBox("one", {100, 100, 0.4});
  addBox("two", {100, 100, 0.4});
  job_.settings.planning.adhesion.brim.width_mm = 8.0;
  job_.settings.planning.infill.density = 0.0;
  for (const PlateArrangement arrangement : {PlateArrangement::Rows, PlateArrangement::Pack}) {
    job_.settings.plate.arrangement = arrangement;
    for (PlatePart& part : job_.plate.parts) part.settings = {};
    job_.settings.plate.spacing_mm = 4.0;
    EXPECT_NEAR(gap(100.0), 4.0 + 2.0 * kBrim, 1e-4);
    job_.settings.planning.skirt.count = 1;
    EXPECT_NE(refusal().find("finds no room"), std::string::npos) << "the skirt goes round the brims";
    job_.settings.planning.skirt.count = 0;
  }
  // 2 mm from the edges of the bed, and 16 mm apart: brims between them do not meet.
  job_.plate.parts[0].at_mm = Point2(52, 110);
  job_.plate.parts[1].at_mm = Point2(168, 110);
  EXPECT_EQ(refusal(), "") << "their brims are cut where they stand";
}

/// Boxes end 5 mm apart, and each brim is 7.86 mm wide: it lies in the other, and below it.
TEST_F(LaidBesideTest, IsRefusedWhereItMeetsAnotherPart) {
  addBox("left", {20, 20, 2}, Point2(80, 110));
  addBox("right", {20, 20, 2}, Point2(105, 110));
  EXPECT_EQ(refusal(), "");
  job_.settings.planning.adhesion.brim.width_mm = 8.0;
  for (const PlateOrder order : {PlateOrder::ByLayer, PlateOrder::ByPart}) {
    job_.settings.plate.order = order;
    EXPECT_EQ(refusal().rfind("parts 'left' and 'right' overlap by ", 0), 0U) << refusal();
    EXPECT_NE(refusal().find("with brim or raft"), std::string::npos) << refusal();
  }
  job_.settings.plate.order = PlateOrder::ByLayer;
  job_.settings.planning.adhesion.brim.width_mm = 2.4;
  EXPECT_EQ(refusal(), "") << "7 pitches, 2.4996 mm";
  job_.settings.planning.adhesion.brim.width_mm = 2.6;
  EXPECT_EQ(refusal(), "") << "7 pitches, too";
  job_.settings.planning.adhesion.brim.width_mm = 2.8;
  EXPECT_NE(refusal(), "") << "8 pitches, 2.8566 mm";
}

/// A brim of 11 pitches, 3.93 mm, ends within the 5 mm; one of 22 does not.
TEST_F(LaidBesideTest, OfOnePartCountsToo) {
  addBox("left", {20, 20, 2}, Point2(80, 110));
  addBox("right", {20, 20, 2}, Point2(105, 110));
  job_.plate.parts[1].settings = {{"brim.width_mm", "4"}};
  EXPECT_EQ(refusal(), "");
  job_.plate.parts[1].settings = {{"brim.width_mm", "8"}};
  EXPECT_EQ(refusal().rfind("parts 'left' and 'right' overlap by ", 0), 0U) << refusal();
}

TEST_F(LaidBesideTest, ArrangedPartsKeepTheirSpacingBetweenIt) {
  addBox("one", {20, 20, 2});
  addBox("two", {20, 20, 2});
  for (const PlateArrangement arrangement : {PlateArrangement::Rows, PlateArrangement::Pack}) {
    job_.settings.plate.arrangement = arrangement;
    job_.settings.planning.adhesion = {};
    EXPECT_NEAR(gap(), 5.0, 1e-6);
    job_.settings.planning.adhesion.brim.width_mm = 8.0;
    EXPECT_NEAR(gap(), 5.0 + 2.0 * kBrim, 1e-4);
    job_.settings.planning.adhesion = {};
    job_.settings.planning.adhesion.raft.layers = 2;
    EXPECT_NEAR(gap(), 5.0 + 2.0 * 3.0, 1e-6);
  }
}

TEST_F(LaidBesideTest, PrimesOnceBeforeAllParts) {
  addBox("one", {10, 10, 1}, Point2(60, 100));
  addBox("two", {10, 10, 1}, Point2(140, 100));
  job_.settings.planning.adhesion.prime.line = PrimeLine::Front;
  for (const int skirts : {0, 1}) {
    job_.settings.planning.skirt.count = skirts;
    NoProgress nobody;
    const Toolpath toolpath = runPlateJob(job_, nobody).sliced.toolpath;
    double primed_mm3 = 0.0;
    for (const ToolpathLayer& layer : toolpath.layers)
      for (const Path& path : layer.paths)
        if (path.role == PathRole::Prime) primed_mm3 += depositedVolume(path);
    EXPECT_NEAR(primed_mm3, 100.0 * 0.5, 1e-6) << "100 mm of 0.5 mm2";
    EXPECT_EQ(toolpath.layers.front().paths.front().role, PathRole::Prime);
  }
  job_.plate.parts[0].at_mm = Point2(60, 6);
  job_.settings.planning.skirt.count = 0;
  EXPECT_NE(refusal().find("prime.line is 'front', where it would cross"), std::string::npos) << refusal();
}

TEST_F(LaidBesideTest, HasNoBrimsOfPartsBesideEachOtherInInclinedLayers) {
  job_.settings.machine.name = "gantry_45";
  job_.settings.slicing.plane.angle_deg = 45.0;
  job_.settings.planning.adhesion.brim.width_mm = 8.0;
  addBox("one", {10, 10, 1}, Point2(60, 100));
  EXPECT_EQ(refusal(), "") << "a part that stands alone has its brim";
  addBox("two", {10, 10, 1}, Point2(140, 100));
  EXPECT_NE(refusal().find("brim.width_mm is 8 for part 'one' of a plate in inclined layers"),
            std::string::npos)
      << refusal();
}

}  // namespace
}  // namespace lamina
