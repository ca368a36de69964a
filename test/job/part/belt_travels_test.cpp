// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/part/belt_travels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

const Eigen::Quaterniond kInclined(Eigen::AngleAxisd(std::atan(1.0), Point3::UnitX()));

/// A point given in layers at 45 deg.
Point3 inLayers(double x, double y, double z) { return kInclined * Point3(x, y, z); }

Path pathOf(PathRole role, std::vector<Point3> points) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.orientation = Eigen::Quaterniond(kInclined * nozzleDown());
  path.feed_mm_s = 100.0;
  if (role != PathRole::Travel) path.bead = Bead{0.4, 0.2};
  return path;
}

/// Two layers of two beads and one bead, with a travel in the first layer and one between them.
Toolpath twoLayers(Path within, Path between) {
  Toolpath toolpath;
  toolpath.part_from_layers = kInclined;
  const Path first = pathOf(PathRole::OuterWall, {inLayers(0, 5, 0.2), inLayers(4, 5, 0.2)});
  const Path second = pathOf(PathRole::OuterWall, {inLayers(8, 6, 0.2), inLayers(12, 6, 0.2)});
  const Path third = pathOf(PathRole::OuterWall, {inLayers(0, 7, 0.4), inLayers(4, 7, 0.4)});
  toolpath.layers = {{0.2, 0.2, {first, std::move(within), second}}, {0.4, 0.2, {std::move(between), third}}};
  return toolpath;
}

Path hopWithin() {
  return pathOf(PathRole::Travel, {inLayers(4, 5, 0.2), inLayers(4, 5, 0.7), inLayers(6, 8, 0.7),
                                   inLayers(8, 6, 0.7), inLayers(8, 6, 0.2)});
}

Path hopBetween() {
  return pathOf(PathRole::Travel,
                {inLayers(12, 6, 0.2), inLayers(12, 6, 0.9), inLayers(0, 7, 0.9), inLayers(0, 7, 0.4)});
}

/// To a place beside the part and 2 mm above where the nozzle stands, back to there, and on.
Path waitBetween(double dwell_s) {
  Path wait = pathOf(PathRole::Travel, {inLayers(12, 6, 0.2), inLayers(12, 6, 2.2), inLayers(-5, 6, 2.2),
                                        inLayers(0, 7, 2.2), inLayers(0, 7, 0.4)});
  wait.events.emplace_back();
  wait.events.back().motion = 2;
  wait.events.back().event.emplace<Dwell>(Dwell{dwell_s});
  return wait;
}

void keepForward(Toolpath& toolpath, const char* machine) {
  keepBeltForward(toolpath, buildSpaceByName(machine), Eigen::Isometry3d::Identity(), MotionLimits{});
  EXPECT_NO_THROW(validate(toolpath));
}

void expectPoints(const Path& path, const std::vector<Point3>& expected) {
  ASSERT_EQ(path.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_LT((path.points[i] - expected[i]).norm(), 1e-9) << "waypoint " << i;
}

TEST(BeltTravels, StayInTheLayerAndPassOverItOnTheWayToTheNext) {
  Toolpath toolpath = twoLayers(hopWithin(), hopBetween());
  keepForward(toolpath, "belt_45");
  expectPoints(toolpath.layers[0].paths[1], {inLayers(4, 5, 0.2), inLayers(6, 8, 0.2), inLayers(8, 6, 0.2)});
  expectPoints(toolpath.layers[1].paths[0],
               {inLayers(12, 6, 0.2), inLayers(12, 6, 0.4), inLayers(0, 7, 0.4)});
}

TEST(BeltTravels, WaitUpTheGantry) {
  Toolpath toolpath = twoLayers(hopWithin(), waitBetween(3.0));
  keepForward(toolpath, "belt_45");
  const Path& wait = toolpath.layers[1].paths[0];
  // The belt would have moved on by another 1.8 / sin 45 deg; the gantry goes as high as before.
  const double lift_mm = 1.8;
  expectPoints(wait, {inLayers(12, 6, 0.2), inLayers(12, 6 + lift_mm, 0.4), inLayers(-5, 6 + lift_mm, 0.4),
                      inLayers(0, 7 + lift_mm, 0.4), inLayers(0, 7, 0.4)});
  EXPECT_EQ(wait.events.at(0).motion, 2u);
  // The way is as long across; up and down it has the root of 0.2^2 + 1.8^2 in place of 2 mm, and 1.8 in
  // place of 1.8.
  EXPECT_GT(std::get<Dwell>(wait.events.at(0).event).duration_s, 3.0);
  EXPECT_LT(std::get<Dwell>(wait.events.at(0).event).duration_s, 3.1);
  Toolpath lifted = twoLayers(hopWithin(), waitBetween(3.0));
  lifted.layers[0].paths[1] = toolpath.layers[0].paths[1];
  EXPECT_NEAR(estimateTime(toolpath, MotionLimits{}).total_s, estimateTime(lifted, MotionLimits{}).total_s,
              0.02);
}

TEST(BeltTravels, AreAsTheyWereWhereNoBeltRunsBack) {
  const Toolpath before = twoLayers(hopWithin(), hopBetween());
  Toolpath gantry = before;
  keepForward(gantry, "gantry_45");
  EXPECT_EQ(toolpathId(gantry), toolpathId(before));
  Toolpath level = before;  // in level layers the beads themselves move the belt
  for (ToolpathLayer& layer : level.layers)
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point = kInclined.conjugate() * point;
  level.part_from_layers = Eigen::Quaterniond::Identity();
  const Toolpath level_before = level;
  keepForward(level, "belt_45");
  EXPECT_EQ(toolpathId(level), toolpathId(level_before));
}

// As a machine of one's own is described by hand: off by 2e-6 rad, where 0.01 deg is accepted.
TEST(BeltTravels, StayInTheLayersOfABeltDescribedWithFewDigits) {
  std::string description = readFile(std::string(LAMINA_SOURCE_DIR) + "/urdf/belt_45.urdf");
  const std::string digits = "0.785398163397448";
  ASSERT_NE(description.find(digits), std::string::npos);
  description.replace(description.find(digits), digits.size(), "0.7854");
  Toolpath toolpath = twoLayers(hopWithin(), hopBetween());
  keepBeltForward(toolpath, buildSpaceFromUrdf(description), Eigen::Isometry3d::Identity(), MotionLimits{});
  EXPECT_EQ(toolpath.layers[0].paths[1].points.size(), 3u);
}

TEST(BeltTravels, StandOffByTheBeltForAScan) {
  // 1 mm above layers of 0.2 mm, and half a layer off those to come: 1.1 mm.
  const Path scan =
      pathOf(PathRole::Travel, {inLayers(12, 6, 0.2), inLayers(12, 6, 1.3), inLayers(12, 0, 1.3),
                                inLayers(0, 7, 1.3), inLayers(0, 7, 0.4)});
  Toolpath toolpath = twoLayers(hopWithin(), hopBetween());
  toolpath.layers[0].paths.push_back(scan);
  toolpath.layers[1].paths.erase(toolpath.layers[1].paths.begin());
  keepBeltForward(toolpath, buildSpaceByName("belt_45"), Eigen::Isometry3d::Identity(), MotionLimits{}, 1.0);
  EXPECT_EQ(toolpath.layers[0].paths[1].points.size(), 3u);
  expectPoints(toolpath.layers[0].paths.back(), scan.points);
}

TEST(BeltTravels, JoinBehindAWaitThatReturns) {
  // The next part lies further on than the wait was lifted.
  Toolpath toolpath = twoLayers(hopWithin(), waitBetween(3.0));
  Path wait = pathOf(PathRole::Travel, {inLayers(12, 6, 0.2), inLayers(12, 6, 2.2), inLayers(-5, 6, 2.2),
                                        inLayers(12, 6, 2.2), inLayers(12, 6, 0.2)});
  wait.events = toolpath.layers[1].paths[0].events;
  toolpath.layers[0].paths.push_back(wait);
  toolpath.layers[1].z_mm = 5.0;
  toolpath.layers[1].paths = {
      pathOf(PathRole::Travel, {inLayers(12, 6, 0.2), inLayers(12, 6, 5.0), inLayers(0, 7, 5.0)}),
      pathOf(PathRole::OuterWall, {inLayers(0, 7, 5.0), inLayers(4, 7, 5.0)})};
  keepForward(toolpath, "belt_45");
  double height = 0.2;
  for (const Path* path : {&toolpath.layers[0].paths.back(), &toolpath.layers[1].paths[0]})
    for (const Point3& point : path->points) {
      EXPECT_GE((kInclined.conjugate() * point).z(), height - 1e-9);
      height = (kInclined.conjugate() * point).z();
    }
  EXPECT_NEAR(height, 5.0, 1e-9);
}

/// What a program says of the belt from its first layer on.
struct BeltWords {
  double first = 0.0;
  double last = 0.0;
  int reversals = 0;
  int with_material = 0;  ///< motions that move the belt and extrude
  int dwells = 0;
  double highest_y = 0.0;  ///< of the gantry [mm]
};

std::optional<double> axisWord(const std::string& line, char letter) {
  const std::size_t at = line.find(std::string(" ") + letter);
  if (at == std::string::npos) return std::nullopt;
  return std::strtod(line.c_str() + at + 2, nullptr);
}

BeltWords beltWordsOf(const std::string& file) {
  BeltWords words;
  std::ifstream program(file);
  bool is_in_part = false;
  std::optional<double> at;
  for (std::string line; std::getline(program, line);) {
    if (line.rfind(";LAYER:0", 0) == 0) is_in_part = true;
    if (line.rfind("; end of the part", 0) == 0) break;
    if (!is_in_part) continue;
    words.dwells += line.rfind("G4", 0) == 0 ? 1 : 0;
    if (line.rfind("G0 ", 0) != 0 && line.rfind("G1 ", 0) != 0) continue;
    words.highest_y = std::max(words.highest_y, axisWord(line, 'Y').value_or(0.0));
    const std::optional<double> belt = axisWord(line, 'Z');
    if (!belt) continue;
    if (!at) words.first = *belt;
    if (at && *belt < *at) ++words.reversals;
    if (at && *belt != *at && axisWord(line, 'E')) ++words.with_material;
    at = words.last = *belt;
  }
  return words;
}

BeltWords beltOfTee(const std::string& machine, const std::vector<SettingText>& overrides) {
  const test::ScratchFolder folder;
  SettingsSources sources;
  sources.machine = machine;
  sources.material = "pla";
  sources.overrides = overrides;
  const LayeredSettings layered =
      loadLayered(sources, ProfileLibrary({std::string(LAMINA_SOURCE_DIR) + "/profiles"}));
  NoProgress nobody;
  runSliceJob({"tee", folder.file("tee.gcode"), layered.settings}, nobody);
  return beltWordsOf(folder.file("tee.gcode"));
}

/// A tee of 76 x 12 x 50 mm, upright: its layers reach over 62 mm of their normal, and the belt moves by 62
/// mm.
TEST(BeltTravels, NeverRunTheBeltBackInThePrograms) {
  for (const std::string machine : {"creality_cr_30", "ideaformer_ir3"}) {
    const BeltWords words = beltOfTee(machine, {});
    EXPECT_EQ(words.reversals, 0) << machine;
    EXPECT_EQ(words.with_material, 0) << machine;
    EXPECT_GT(words.dwells, 0) << machine;
    EXPECT_NEAR(words.last - words.first, 62.0, 0.6) << machine;
  }
  EXPECT_EQ(beltOfTee("creality_cr_30", {{"travel.hop_mm", "2"}, {"travel.comb", "none"}}).reversals, 0);
  const BeltWords at_corner =
      beltOfTee("creality_cr_30", {{"pause.at_layers", "20"}, {"cooling.park", "corner"}});
  EXPECT_EQ(at_corner.reversals, 0);
  // The tee is 50 mm high, 50 / sin 45 deg up the gantry, and waits lift the nozzle by 2 mm / tan 45 deg.
  EXPECT_LT(at_corner.highest_y, 50.0 / std::sin(std::atan(1.0)) + 2.1);
  EXPECT_EQ(beltOfTee("creality_cr_30",
                      {{"cooling.interval", "place"}, {"cooling.by", "dwell"}, {"cooling.park", "stay"}})
                .reversals,
            0);
}

/// The brim of a box of 12 mm begins before it, where the belt begins, and is 3 mm wide to its sides.
TEST(BeltBrim, BeginsWhereTheBeltBegins) {
  const test::ScratchFolder folder;
  SettingsSources sources;
  sources.machine = "creality_cr_30";
  sources.material = "pla";
  sources.overrides = {{"brim.width_mm", "3"}};
  const JobSettings settings =
      loadLayered(sources, ProfileLibrary({std::string(LAMINA_SOURCE_DIR) + "/profiles"})).settings;
  NoProgress nobody;
  const std::string box = folder.file("box.stl");
  writeStl(box, test::boxBetween(Point3::Zero(), {12, 12, 12}));
  const SlicedPart sliced = runSliceJob({box, folder.file("box.gcode"), settings}, nobody);
  Box3 brim;
  Box3 part;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      for (const Point3& point : path.points) (path.role == PathRole::Brim ? brim : part).include(point);
    }
  ASSERT_FALSE(brim.isEmpty());
  EXPECT_NEAR(part.low.x() - brim.low.x(), 3.0, 0.3);
  EXPECT_NEAR(brim.high.x() - part.high.x(), 3.0, 0.3);
  EXPECT_GT(brim.size().y(), 12.0 + 2 * 2.5);
  EXPECT_LT(brim.size().y(), 12.0 + 2 * 3.5);
}

}  // namespace
}  // namespace lamina
