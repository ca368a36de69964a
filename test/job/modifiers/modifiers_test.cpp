// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Regions of a part with settings of their own, from file to toolpath.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/modifiers/modifier.hpp"
#include "lamina/job/plate/plate_job.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

class ModifiersTest : public ::testing::Test {
 protected:
  ModifiersTest() {
    job_.part = folder_.file("cube.stl");
    writeStl(job_.part, test::boxBetween({0, 0, 0}, {20, 20, 4}));
    job_.settings.planning = PlanSettings{};
    job_.settings.planning.skirt.count = 0;
    job_.settings.planning.infill.density = 0.0;
    job_.settings.modifiers = folder_.file("modifiers.yaml");
  }

  void write(const std::string& list) { std::ofstream(job_.settings.modifiers) << "modifiers:\n" << list; }

  Toolpath run() {
    NoProgress nobody;
    Toolpath toolpath = runSliceJob(job_, nobody).toolpath;
    validate(toolpath);
    return toolpath;
  }

  std::string refusal() {
    try {
      run();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test::ScratchFolder folder_;
  SliceJob job_;
};

Box3 infillBox(const Toolpath& toolpath) {
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Infill)
        for (const Point3& point : path.points) box.include(point);
  return box;
}

TEST_F(ModifiersTest, HoldInABox) {
  write("  - {box_mm: [[10, -1, 1], [21, 21, 3]], settings: {infill.density: 0.3}}\n");
  const Box3 box = infillBox(run());
  EXPECT_GT(box.low.x(), 10.0 - 0.1);
  EXPECT_NEAR(box.low.z(), 1.2, 1e-9);  // top of the first layer whose middle lies in it
  EXPECT_NEAR(box.high.z(), 3.0, 1e-9);
}

// A lattice of squares in a corner cut off at 45 degrees.
TEST_F(ModifiersTest, SaysWhatCellsOfASolidInfillInARegionLeaveOpen) {
  writeStl(job_.part, makePart("cylinder", {{"radius_mm", "10"}, {"height_mm", "1"}}));
  job_.settings.planning.infill.density = 1.0;
  const auto noteOf = [this](const std::string& list) {
    write(list);
    NoProgress nobody;
    std::string found;
    for (const std::string& note : runSliceJob(job_, nobody).summary.notes)
      if (note.rfind("cells of solid infill", 0) == 0) found = note;
    return found;
  };
  const std::string note =
      noteOf("  - {box_mm: [[0, 0, -1], [10, 10, 3]], settings: {infill.strategy: hilbert}}\n");
  EXPECT_EQ(note.rfind("cells of solid infill of regions do not fit everywhere: ", 0), 0U) << note;
  EXPECT_EQ(noteOf("  - {box_mm: [[0, 0, -1], [10, 10, 3]], settings: {infill.strategy: zigzag}}\n"), "");
}

TEST_F(ModifiersTest, HoldInAMesh) {
  writeStl(folder_.file("boss.stl"), test::boxBetween({5, 5, -1}, {15, 15, 9}));
  write("  - {mesh: boss.stl, settings: {infill.density: 0.3}}\n");
  const Box3 box = infillBox(run());
  EXPECT_GT(box.low.x(), 4.9);
  EXPECT_LT(box.high.y(), 15.1);
}

TEST_F(ModifiersTest, HoldInARangeOfHeightsAboveTheFoot) {
  writeStl(job_.part, test::boxBetween({0, 0, 50}, {20, 20, 54}));
  write("  - {from_mm: 1, to_mm: 2, settings: {infill.density: 0.3}}\n");
  const Box3 box = infillBox(run());
  EXPECT_NEAR(box.low.z(), 51.2, 1e-9);
  EXPECT_NEAR(box.high.z(), 52.0, 1e-9);
}

TEST_F(ModifiersTest, AddUpWhereTheyOverlapTheLastOfEachKeyWins) {
  job_.settings.planning.walls.count = 1;
  write(
      "  - {from_mm: 0, settings: {infill.density: 0.3, walls.count: 2}}\n"
      "  - {from_mm: 2, settings: {walls.count: 3}}\n");
  const Toolpath toolpath = run();
  const auto walls = [&](std::size_t layer) {
    int count = 0;
    for (const Path& path : toolpath.layers[layer].paths)
      count += static_cast<int>(kindOf(path.role) == RoleKind::Wall);
    return count;
  };
  EXPECT_EQ(walls(3), 2);
  EXPECT_EQ(walls(15), 3);
  EXPECT_NEAR(infillBox(toolpath).high.z(), 4.0, 1e-9);
}

TEST_F(ModifiersTest, CutAway) {
  job_.settings.planning.infill.density = 1.0;
  write("  - {box_mm: [[5, 5, -1], [15, 15, 9]], kind: negative}\n");
  NoProgress nobody;
  const SlicedPart sliced = runSliceJob(job_, nobody);
  EXPECT_NEAR(sliced.summary.sliced_volume_mm3, (400.0 - 100.0) * 4.0, 1e-6);
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points)
        EXPECT_TRUE(path.role == PathRole::Travel ||
                    (point.head<2>() - Point2(10, 10)).cwiseAbs().maxCoeff() > 5.0);
}

TEST_F(ModifiersTest, TurnWithTheirPartOnAPlate) {
  write("  - {box_mm: [[10, -1, -1], [21, 21, 9]], settings: {infill.density: 0.3}}\n");
  PlateJob plate;
  plate.settings = job_.settings;
  plate.plate = plateOf({job_.part});
  plate.plate.parts[0].at_mm = Point2(100, 100);
  plate.plate.parts[0].turn_deg = {0, 0, 90};  // what was right is behind
  NoProgress nobody;
  const Box3 box = infillBox(runPlateJob(plate, nobody).sliced.toolpath);
  EXPECT_GT(box.low.y(), 100.0 - 0.1);
  EXPECT_LT(box.low.x(), 92.0);
}

TEST_F(ModifiersTest, AreRefusedByNameAndPlace) {
  write("  - {from_mm: 0, settings: {bead.width_mm: 1}}\n");
  EXPECT_NE(refusal().find("'bead.width_mm' cannot be set for a region"), std::string::npos) << refusal();
  write("  - {from_mm: 0, settings: {infill.densty: 1}}\n");
  EXPECT_NE(refusal().find("modifier 0: "), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("infill.densty"), std::string::npos) << refusal();
  write("  - {from_mm: 3, to_mm: 2, settings: {infill.density: 1}}\n");
  EXPECT_NE(refusal().find("from_mm is 3"), std::string::npos) << refusal();
  write("  - {box_mm: [[0, 0, 0], [1, 1, 1]], kind: seam_there}\n");
  EXPECT_NE(refusal().find("seam_there"), std::string::npos) << refusal();
  write("  - {box_mm: [[0, 0, 0], [1, 1, 1]], kind: support_blocker, settings: {infill.density: 1}}\n");
  EXPECT_NE(refusal().find("expected no settings"), std::string::npos) << refusal();
  for (const std::string key :
       {"supports.top_gap_mm", "feed.support_mm_s", "tool.support", "overhangs.use"}) {
    write("  - {box_mm: [[0, 0, 0], [1, 1, 1]], settings: {" + key + ": 1}}\n");
    EXPECT_NE(refusal().find("'" + key + "'"), std::string::npos) << refusal();
  }
  write("  - {box_mm: [[0, 0, 0], [1, 1, 1]], settings: {seam.placement: rear}}\n");
  EXPECT_NE(refusal().find("whole layers"), std::string::npos) << refusal();
  write("  - {mesh: nothing.stl, settings: {infill.density: 1}}\n");
  EXPECT_NE(refusal().find("modifier 0: "), std::string::npos) << refusal();
  Mesh open = test::boxBetween({0, 0, 0}, {5, 5, 5});
  open.triangles.pop_back();
  writeStl(folder_.file("open.stl"), open);
  write("  - {mesh: open.stl, settings: {infill.density: 1}}\n");
  EXPECT_NE(refusal(), "");
  job_.settings.slicing.mode = "curved";
  EXPECT_NE(refusal().find("part.modifiers"), std::string::npos) << refusal();
}

/// By default walls start at (0, 0); a post in a corner or on a side takes them over, in its layers alone.
TEST_F(ModifiersTest, WallsStartWhereSeamsArePut) {
  const auto startsOf = [](const Toolpath& toolpath, std::size_t layer) {
    std::vector<Point2> starts;
    for (const Path& path : toolpath.layers.at(layer).paths)
      if (path.role == PathRole::OuterWall || path.role == PathRole::InnerWall)
        starts.emplace_back(path.firstPoint().head<2>());
    return starts;
  };
  write("  - {box_mm: [[7, -1, 1], [12, 3, 3]], kind: seam_here}\n");
  const Toolpath toolpath = run();
  double low = 1e9;
  for (const Point2& start : startsOf(toolpath, 0)) low = std::min(low, start.x());
  const auto inMiddle = [&](std::size_t layer) {
    const std::vector<Point2> starts = startsOf(toolpath, layer);
    EXPECT_EQ(starts.size(), 2U);
    return std::all_of(starts.begin(), starts.end(),
                       [&](const Point2& start) { return std::abs(start.x() + 0.2 - low - 9.5) < 0.4; });
  };
  EXPECT_FALSE(inMiddle(0));
  EXPECT_TRUE(inMiddle(10)) << "from 2 to 2.2 mm";
  EXPECT_FALSE(inMiddle(17));
}

TEST_F(ModifiersTest, SupportsOfARegionHaveTheirOwnLines) {
  job_.part = "tee";
  job_.settings.planning.supports.use = true;
  const auto supported_mm3 = [this] {
    double volume = 0.0;
    for (const ToolpathLayer& layer : run().layers)
      for (const Path& path : layer.paths)
        if (path.role == PathRole::Support) volume += depositedVolume(path);
    return volume;
  };
  write("  - {box_mm: [[-100, -100, 0], [100, 100, 100]], settings: {supports.density: 0.3}}\n");
  const double dense = supported_mm3();
  job_.settings.modifiers.clear();
  const double sparse = supported_mm3();
  EXPECT_GT(dense, 1.5 * sparse) << "lines are twice as dense, links at their ends as long as before";
  job_.settings.planning.supports.density = 0.3;
  EXPECT_NEAR(dense, supported_mm3(), 1e-6) << "the region is the whole part";
  job_.settings.modifiers = folder_.file("modifiers.yaml");
  for (const char* const key : {"supports.top_gap_mm: 0.1", "supports.kind: tree", "supports.tool: 0"}) {
    write(std::string("  - {box_mm: [[0, 0, 0], [9, 9, 9]], settings: {") + key + "}}\n");
    const std::string text = refusal();
    EXPECT_NE(text.find(std::string(key).substr(0, std::string(key).find(':'))), std::string::npos) << text;
    EXPECT_NE(text.find("cannot be set for a region"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace lamina
