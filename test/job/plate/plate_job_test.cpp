// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/plate/plate_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <string>

#include "job/plate/plate_toolpath.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

class PlateJobTest : public ::testing::Test {
 protected:
  /// A box of that size in a file of that name.
  std::string box(const std::string& name, const Point3& size) {
    std::string path = folder_.file(name + ".stl");
    writeStl(path, test::boxBetween(Point3::Zero(), size));
    return path;
  }

  PlatePart& add(const std::string& file, const std::optional<Point2>& at = std::nullopt) {
    job_.plate.parts.emplace_back();
    job_.plate.parts.back().file = file;
    job_.plate.parts.back().at_mm = at;
    return job_.plate.parts.back();
  }

  SlicedPlate run() {
    NoProgress nobody;
    SlicedPlate plate = runPlateJob(job_, nobody);
    validate(plate.sliced.toolpath);
    return plate;
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
  PlateJob job_;
};

/// What is deposited, by the part that the marks name; empty for none.
std::map<std::string, double> volumesByPart(const Toolpath& toolpath) {
  std::map<std::string, double> volumes;
  std::string part;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      std::string next = part;
      for (const PathEvent& placed : path.events)
        if (const auto* const mark = std::get_if<PartMark>(&placed.event)) {
          next = mark->name;
          if (placed.motion == 0) part = next;
        }
      volumes[part] += depositedVolume(path);
      part = next;
    }
  return volumes;
}

/// How far a motion rises above its layer at most [mm].
double greatestRise(const ToolpathLayer& layer) {
  double rise_mm = 0.0;
  for (const Path& path : layer.paths)
    for (const Point3& point : path.points) rise_mm = std::max(rise_mm, point.z() - layer.z_mm);
  return rise_mm;
}

double depositedIn(const Toolpath& toolpath) { return totals(toolpath).deposited_mm3; }

TEST_F(PlateJobTest, TurnsContoursExactly) {
  for (const double angle_deg : {0.0, 30.0, 45.0, 90.0}) {
    Mesh mesh = test::boxBetween({3, 4, 5}, {23, 24, 7});
    const Eigen::Affine3d part_from_file = standing(mesh, rotationOfDegrees({0, 0, angle_deg}), 1.0);
    mesh = transformed(std::move(mesh), part_from_file);
    NoProgress nobody;
    const std::vector<Section> sections = sliceMesh(mesh, {1.0}, nobody);
    ASSERT_EQ(sections[0].contours.size(), 1U);
    const double angle = angle_deg * M_PI / 180.0;
    for (const Point2& corner : test::rectangle(-10, -10, 10, 10)) {
      const Point2 turned(std::cos(angle) * corner.x() - std::sin(angle) * corner.y(),
                          std::sin(angle) * corner.x() + std::cos(angle) * corner.y());
      EXPECT_LT(test::distanceToOutline(sections[0].contours, turned), 1e-9) << angle_deg;
    }
    EXPECT_NEAR(signedArea(sections[0].contours), 400.0, 1e-9);
  }
}

/// Beside a part that has its place another stands in the corner of the bed, 20 / 0.95 mm wide as it is
/// printed.
TEST_F(PlateJobTest, LeavesRoomForPartsAsTheyAreGrownForShrinkage) {
  add(box("placed", {20, 20, 0.4}), Point2(110, 110));
  add(box("beside", {20, 20, 0.4}));
  job_.settings.planning.skirt.count = 0;
  job_.settings.compensation.shrink_xy = 0.05;
  EXPECT_EQ(refusal(), "");
  const Point2 at = run().parts[1].at_mm;
  EXPECT_GE(at.minCoeff(), 10.0 / 0.95 - 1e-6);
}

TEST_F(PlateJobTest, TurnsAboutFixedAxesInOrder) {
  // x to y about z comes last: the box's x edge, up by the turn about y, stays up.
  const Mesh mesh = test::boxBetween({0, 0, 0}, {10, 20, 30});
  const Box3 box = boundingBox(transformed(mesh, standing(mesh, rotationOfDegrees({90, 0, 90}), 2.0)));
  EXPECT_LT((box.size() - Point3(60, 20, 40)).norm(), 1e-9);
  EXPECT_LT((box.low - Point3(-30, -10, 0)).norm(), 1e-9);
}

TEST_F(PlateJobTest, LaysWhatSinglePartsLay) {
  const std::string file = box("box", {20, 10, 2});
  double singles_mm3 = 0.0;
  job_.settings.planning.skirt.count = 0;
  double x = 30;
  for (const double angle_deg : {0.0, 30.0, 45.0, 90.0}) {
    add(file, Point2(x += 30, 100)).turn_deg.z() = angle_deg;
    const std::string turned = folder_.file("turned" + std::to_string(int(angle_deg)) + ".stl");
    const Mesh mesh = test::boxBetween(Point3::Zero(), {20, 10, 2});
    writeStl(turned, transformed(mesh, standing(mesh, rotationOfDegrees({0, 0, angle_deg}), 1.0)));
    NoProgress nobody;
    singles_mm3 += depositedIn(runSliceJob({turned, "", job_.settings}, nobody).toolpath);
  }
  const SlicedPlate plate = run();
  EXPECT_NEAR(depositedIn(plate.sliced.toolpath) / singles_mm3, 1.0, 1e-6);
  EXPECT_EQ(plate.sliced.toolpath.layers.size(), 10U);
  ASSERT_EQ(plate.parts.size(), 4U);
  EXPECT_EQ(plate.parts[1].name, "box 2");
}

TEST_F(PlateJobTest, RefusesPartsThatOverlapByBothNames) {
  add(box("left", {20, 20, 5}), Point2(100, 100));
  add(box("right", {20, 20, 3}), Point2(119.9, 100));
  const std::string text = refusal();
  EXPECT_NE(text.find("'left' and 'right' overlap by 2 mm2"), std::string::npos) << text;
  job_.plate.parts[1].at_mm = Point2(120.0, 100);
  EXPECT_EQ(refusal(), "");
}

TEST_F(PlateJobTest, LetsPartsStandInEachOthersBoxes) {
  // An L of two boxes, and a box in its corner.
  const std::string path = folder_.file("L.stl");
  writeStl(path, joined(test::boxBetween({0, 0, 0}, {30, 10, 2}), test::boxBetween({0, 10, 0}, {10, 30, 2})));
  add(path, Point2(100, 100));
  add(box("corner", {10, 10, 2}), Point2(105, 105));
  EXPECT_EQ(refusal(), "");
}

TEST_F(PlateJobTest, RefusesPartsOffTheBedByName) {
  add(box("outside", {20, 20, 5}), Point2(5, 100));
  EXPECT_NE(refusal().find("part 'outside' reaches to x -5 mm"), std::string::npos) << refusal();
}

TEST_F(PlateJobTest, RefusesWhatFindsNoRoom) {
  job_.plate.parts.clear();
  add(box("large", {120, 120, 1})).copies = 2;
  for (const PlateArrangement arrangement : {PlateArrangement::Rows, PlateArrangement::Pack}) {
    job_.settings.plate.arrangement = arrangement;
    EXPECT_NE(refusal().find("part 'large 2' of 120 x 120 mm finds no room"), std::string::npos) << refusal();
  }
}

TEST_F(PlateJobTest, MergesLayersOfDifferentHeightsByTheirTops) {
  const std::string file = box("box", {10, 10, 1.2});
  add(file);
  add(file).settings = {{"slicing.layer_height_mm", "0.3"}, {"slicing.first_layer_height_mm", "0.3"}};
  const Toolpath toolpath = run().sliced.toolpath;
  std::vector<double> tops;
  for (const ToolpathLayer& layer : toolpath.layers) {
    EXPECT_TRUE(tops.empty() || layer.z_mm >= tops.back() - 1e-9);
    tops.push_back(layer.z_mm);
    for (const Path& path : layer.paths)
      EXPECT_TRUE(path.role == PathRole::Travel || std::abs(path.firstPoint().z() - layer.z_mm) < 1e-9);
  }
  EXPECT_EQ(tops.size(), 10U);  // 0.2, 0.3, 0.4, 0.6 twice, ..., 1.2 twice
  const auto volumes = volumesByPart(toolpath);
  EXPECT_NEAR(volumes.at("box 1") / volumes.at("box 2"), 1.0, 0.1);
}

TEST_F(PlateJobTest, GivesPartsSettingsOfTheirOwn) {
  const std::string file = box("box", {20, 20, 2});
  job_.settings.planning = PlanSettings{};
  job_.settings.planning.walls.count = 0;
  add(file).name = "dense";
  job_.plate.parts.back().settings = {{"infill.density", "1"}};
  add(file).name = "sparse";
  const auto volumes = volumesByPart(run().sliced.toolpath);
  EXPECT_NEAR(volumes.at("dense"), 20 * 20 * 2, 0.05 * 800);
  EXPECT_LT(volumes.at("sparse"), 0.35 * volumes.at("dense"));
  job_.plate.parts[0].settings = {{"program.flow", "2"}};
  EXPECT_NE(refusal().find("'program.flow'"), std::string::npos) << refusal();
}

TEST_F(PlateJobTest, LaysOneSkirtAroundAll) {
  const std::string file = box("box", {10, 10, 1});
  add(file, Point2(60, 100));
  add(file, Point2(140, 100));
  const Toolpath toolpath = run().sliced.toolpath;
  std::size_t skirts = 0;
  double nearest = 1e9;
  const std::vector<Polygon> hull = {test::rectangle(55, 95, 145, 105)};
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role != PathRole::Skirt) continue;
      ++skirts;
      for (const Point3& point : path.points)
        nearest = std::min(nearest, test::distanceToOutline(hull, point.head<2>()));
    }
  EXPECT_EQ(skirts, 1U);
  EXPECT_NEAR(nearest, 4.0 + 0.2, 0.01);
  EXPECT_EQ(toolpath.layers.front().paths.front().role, PathRole::Skirt);
}

TEST_F(PlateJobTest, MarksPartsThatAreReadBack) {
  add(box("one", {10, 10, 1}));
  add(box("two", {12, 10, 1}));
  job_.output = folder_.file("plate.gcode");
  for (const ObjectLabels labels : {ObjectLabels::None, ObjectLabels::M486, ObjectLabels::ExcludeObject}) {
    job_.settings.plate.labels = labels;
    job_.settings.program.dialect = labels == ObjectLabels::ExcludeObject ? "klipper" : "marlin";
    const auto planned = volumesByPart(run().sliced.toolpath);
    const auto read = volumesByPart(toolpathFromGcodeFile(job_.output, job_.settings.program));
    ASSERT_EQ(read.size(), 3U);
    for (const auto& [name, volume_mm3] : planned) EXPECT_NEAR(read.at(name), volume_mm3, 1e-2) << name;
  }
}

/// Each part lies on the bed by itself, also after others.
TEST_F(PlateJobTest, HeatsTheFirstLayerOfEachPartOneAfterTheOther) {
  const std::string file = box("box", {10, 10, 1});
  for (const double x : {40, 120, 200}) add(file, Point2(x, 100));
  job_.settings.program.nozzle_temperature_c = 210;
  job_.settings.program.bed_temperature_c = 60;
  job_.settings.planning.first_layer.nozzle_temperature_c = 215;
  job_.settings.planning.first_layer.bed_temperature_c = 65;
  const auto heats = [this](PlateOrder order) {
    job_.settings.plate.order = order;
    std::string codes;
    for (const ToolpathLayer& layer : run().sliced.toolpath.layers)
      for (const Path& path : layer.paths)
        for (const PathEvent& placed : path.events)
          if (const auto* const code = std::get_if<MachineCode>(&placed.event)) codes += code->text;
    return codes;
  };
  const std::string rest = "M104 S210\nM140 S60\n";
  const std::string first = "M104 S215\nM140 S65\n";
  EXPECT_EQ(heats(PlateOrder::ByLayer), rest);
  EXPECT_EQ(heats(PlateOrder::ByPart), rest + first + rest + first + rest);
}

TEST_F(PlateJobTest, LabelsPartsForFirmware) {
  add(box("my part", {10, 10, 1})).copies = 2;
  job_.settings.fan.is_used = false;
  job_.output = folder_.file("plate.gcode");
  job_.settings.plate.labels = ObjectLabels::M486;
  run();
  const std::string marlin = readFile(job_.output);
  EXPECT_NE(marlin.find("M486 T2\n"), std::string::npos);
  EXPECT_NE(marlin.find(";PART:my part 1\nM486 S0\n"), std::string::npos);
  EXPECT_NE(marlin.find(";PART:my part 2\nM486 S1\n"), std::string::npos);
  EXPECT_NE(marlin.find("M486 S-1\n; end of the part"), std::string::npos);
  job_.settings.plate.labels = ObjectLabels::ExcludeObject;
  job_.settings.program.dialect = "klipper";
  run();
  const std::string klipper = readFile(job_.output);
  EXPECT_NE(klipper.find("EXCLUDE_OBJECT_DEFINE NAME=my_part_1 CENTER="), std::string::npos);
  EXPECT_NE(klipper.find("EXCLUDE_OBJECT_END NAME=my_part_1\nEXCLUDE_OBJECT_START NAME=my_part_2\n"),
            std::string::npos);
  job_.settings.plate.labels = ObjectLabels::None;
  run();
  EXPECT_EQ(readFile(job_.output).find("M486"), std::string::npos);
}

TEST_F(PlateJobTest, PrintsPartAfterPartTheLowestFirst) {
  job_.settings.cooling.least_layer_time_s = 0.0;  // waits rise as well
  job_.settings.plate.order = PlateOrder::ByPart;
  add(box("high", {10, 10, 4}), Point2(60, 60));
  add(box("low", {10, 10, 2}), Point2(120, 60));
  const Toolpath toolpath = run().sliced.toolpath;
  ASSERT_EQ(toolpath.layers.size(), 30U);
  EXPECT_NEAR(toolpath.layers[9].z_mm, 2.0, 1e-9);
  EXPECT_NEAR(toolpath.layers[10].z_mm, 0.2, 1e-9);
  const Path& way = toolpath.layers[10].paths.front();
  ASSERT_EQ(way.role, PathRole::Travel);
  EXPECT_TRUE(way.process.is_retracted);
  for (std::size_t i = 1; i + 1 < way.points.size(); ++i) EXPECT_GE(way.points[i].z(), 2.0);
  // Over its own place the nozzle needs not rise above others.
  for (std::size_t k = 11; k < toolpath.layers.size(); ++k)
    EXPECT_LE(greatestRise(toolpath.layers[k]), job_.settings.planning.travel.hop_mm + 1e-9) << k;
}

TEST_F(PlateJobTest, RefusesAnOrderInWhichTheHeadWouldTouchAFinishedPart) {
  job_.settings.plate.order = PlateOrder::ByPart;
  add(box("first", {10, 10, 30}), Point2(60, 60));  // a head of 40 mm, 25 mm above the tip
  add(box("second", {10, 10, 31}), Point2(80, 60));
  const std::string text = refusal();
  EXPECT_NE(text.find("while part 'second' is printed, link 'head'"), std::string::npos) << text;
  EXPECT_NE(text.find("over the finished part 'first'"), std::string::npos) << text;
  job_.plate.parts[1].at_mm = Point2(100, 60);
  EXPECT_EQ(refusal(), "");
}

/// The head stands 30 mm beside the nozzle of the second tool: over the first part, or farther from it.
TEST_F(PlateJobTest, CountsTheOffsetOfTheToolWhereTheHeadPassesFinishedParts) {
  job_.settings.plate.order = PlateOrder::ByPart;
  add(box("first", {10, 10, 30}), Point2(60, 60));
  add(box("second", {10, 10, 31}), Point2(100, 60));
  const auto refusalWith = [this](const char* offset_mm) {
    job_.settings.planning.tools.list = {{"0.name", "one"}, {"1.offset_mm", offset_mm}};
    return refusal();
  };
  EXPECT_EQ(refusalWith("30,0,0"), "") << "the second tool lays nothing";
  ToolSettings& tools = job_.settings.planning.tools;
  tools.walls = tools.skin = tools.infill = 1;
  EXPECT_NE(refusalWith("30,0,0").find("while part 'second' is printed, link 'head'"), std::string::npos);
  EXPECT_EQ(refusalWith("-30,0,0"), "");
}

/// Each level of a prime tower begins with its walls, two squares in one path.
TEST_F(PlateJobTest, StacksLevelsOfATowerBesideLayersOfOtherHeights) {
  constexpr std::size_t kWallPoints = 10;
  add(box("low", {10, 10, 1.2}), Point2(60, 60));
  add(box("high", {10, 10, 3}), Point2(90, 60));
  PlanSettings& planning = job_.settings.planning;
  planning.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  planning.tools.infill = 1;
  planning.tools.purge_mm3 = {30.0};
  planning.skins.top_layers = planning.skins.bottom_layers = 1;
  for (const char* const height_mm : {"0.3", "0.25", "0.21", "0.2"}) {
    job_.plate.parts.back().settings = {{"slicing.layer_height_mm", height_mm},
                                        {"slicing.first_layer_height_mm", height_mm}};
    double top_mm = 0.0, deposited_mm = 0.0, purged_mm3 = 0.0;
    std::size_t changes = 0;
    std::optional<std::uint32_t> tool;
    for (const ToolpathLayer& layer : run().sliced.toolpath.layers)
      for (const Path& path : layer.paths) {
        if (path.role == PathRole::Travel || path.role == PathRole::Skirt) continue;
        if (tool.value_or(path.tool) != path.tool) ++changes;
        tool = path.tool;
        EXPECT_GE(path.firstPoint().z(), deposited_mm - 1e-9) << "below what is deposited, at " << height_mm;
        deposited_mm = path.firstPoint().z();
        if (path.role != PathRole::Prime) continue;
        purged_mm3 += depositedVolume(path);
        EXPECT_LE(path.bead.at(0).height_mm, 1.5 * 0.3);
        if (path.points.size() == kWallPoints) {
          // A layer less than half a layer above its level lays from where it is.
          top_mm += path.bead.at(0).height_mm;
          EXPECT_GE(deposited_mm, top_mm - 1e-9) << height_mm;
          EXPECT_LT(deposited_mm, top_mm + 0.5 * 0.2) << height_mm;
        }
      }
    EXPECT_GT(changes, 10U);
    EXPECT_GE(purged_mm3, 0.99 * 30.0 * static_cast<double>(changes));
  }
}

TEST_F(PlateJobTest, RefusesWhatPlatesDoNotTake) {
  add(box("box", {10, 10, 1}));
  job_.settings.slicing.mode = "curved";
  EXPECT_NE(refusal().find("slicing.mode"), std::string::npos);
  job_.settings.slicing.mode = "planar";
  job_.settings.scan.every_layers = 2;
  EXPECT_NE(refusal().find("scan.every_layers"), std::string::npos);
  job_.settings.scan.every_layers = 0;
  job_.settings.planning.tools.purge_mm3 = {50.0};
  job_.settings.plate.order = PlateOrder::ByPart;
  EXPECT_NE(refusal().find("tools.purge_mm3"), std::string::npos);
  job_.settings.planning.tools.purge_mm3.clear();
  job_.settings.plate.order = PlateOrder::ByLayer;
  job_.settings.planning.skirt.layers = 2;
  EXPECT_NE(refusal().find("skirt.layers"), std::string::npos);
  job_.settings.planning.skirt.layers = 1;
  job_.plate.parts.clear();
  EXPECT_NE(refusal().find("no part"), std::string::npos);
}

TEST(PlateToolpath, MergesPartsThatStandOnRaftsByTheirHeightOnThePlate) {
  // One begins 0.3 mm below its origin, which stands so much above the bed; the other at its origin.
  const auto partOf = [](double first_mm) {
    Toolpath toolpath;
    for (const double z : {first_mm, first_mm + 0.2}) {
      Path path;
      path.points = {{0, 0, z}, {5, 0, z}};
      path.bead = Bead{0.4, 0.2};
      path.feed_mm_s = 20.0;
      toolpath.layers.push_back({z, 0.2, {path}});
    }
    return toolpath;
  };
  const Toolpath raised = partOf(-0.1);
  const Toolpath level = partOf(0.2);
  const Toolpath plate =
      mergedByLayer({{"raised", &raised, {10, 0, 0.3}}, {"level", &level, {30, 0, 0}}}, TravelSettings());
  validate(plate);
  ASSERT_EQ(plate.layers.size(), 2U);
  EXPECT_NEAR(plate.layers[0].z_mm, 0.2, 1e-9);
  for (const ToolpathLayer& layer : plate.layers) {
    ASSERT_EQ(layer.paths.back().role, PathRole::Infill);
    for (const Path& path : layer.paths)
      EXPECT_TRUE(path.role == PathRole::Travel || std::abs(path.firstPoint().z() - layer.z_mm) < 1e-9);
  }
}

TEST(PlateFile, IsReadWithPlacesTurnsAndSettings) {
  const Plate plate = readPlate(R"(
plate:
  parts:
    - {file: box, at_mm: [50, 60], turn_deg: [0, 0, 30], scale: 2, settings: {infill.density: 0.2}}
    - {file: cone, copies: 3, name: hat}
  arrange: pack
  spacing_mm: 3
  order: by_part
)",
                                "plate.yaml", "");
  ASSERT_EQ(plate.parts.size(), 2U);
  EXPECT_EQ(*plate.parts[0].at_mm, Point2(50, 60));
  EXPECT_EQ(plate.parts[0].turn_deg, Point3(0, 0, 30));
  EXPECT_EQ(plate.parts[0].scale, 2.0);
  ASSERT_EQ(plate.parts[0].settings.size(), 1U);
  EXPECT_EQ(plate.parts[0].settings[0].key, "infill.density");
  EXPECT_EQ(plate.parts[1].copies, 3);
  EXPECT_EQ(plate.parts[1].name, "hat");
  ASSERT_EQ(plate.settings.size(), 3U);
  EXPECT_EQ(plate.settings[0].key, "plate.arrange");
}

TEST(PlateFile, IsRefusedByLineAndKey) {
  const auto refusalOf = [](const std::string& part) {
    try {
      readPlate("plate:\n  parts:\n    - " + part + "\n", "plate.yaml", "");
    } catch (const InvalidConfig& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusalOf("{at_mm: [1, 2]}").find("plate.yaml:3"), std::string::npos);
  EXPECT_NE(refusalOf("{file: box, colour: red}").find("unknown key"), std::string::npos);
  EXPECT_NE(refusalOf("{file: box, at_mm: [1]}").find("two numbers"), std::string::npos);
  EXPECT_NE(refusalOf("{file: box, scale: 0}").find("above 0"), std::string::npos);
  EXPECT_NE(refusalOf("{file: box, settings: {machine.name: belt_45}}").find("machine.name"),
            std::string::npos);
}

/// Values of the belt over what is deposited, by part.
std::map<std::string, std::pair<double, double>> beltByPart(const SlicedPart& plate) {
  const CartesianMachine machine = machineByName("belt_45");
  std::map<std::string, std::pair<double, double>> spans;
  std::string part;
  for (const ToolpathLayer& layer : plate.toolpath.layers)
    for (const Path& path : layer.paths) {
      for (const PathEvent& placed : path.events)
        if (const auto* const mark = std::get_if<PartMark>(&placed.event))
          if (placed.motion == 0) part = mark->name;
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) {
          const double belt = axisValues(machine, plate.bed_from_part * point).z();
          auto& span = spans.emplace(part, std::pair(belt, belt)).first->second;
          span = {std::min(span.first, belt), std::max(span.second, belt)};
        }
      for (const PathEvent& placed : path.events)
        if (const auto* const mark = std::get_if<PartMark>(&placed.event)) part = mark->name;
    }
  return spans;
}

TEST_F(PlateJobTest, PartsFollowEachOtherAlongABelt) {
  job_.settings.machine.name = "belt_45";
  job_.settings.slicing.plane.angle_deg = 45.0;
  job_.settings.slicing.layer_height_mm = job_.settings.slicing.first_layer_height_mm = 1.0;
  job_.settings.planning.bead.width_mm = 1.2;
  job_.settings.copies.spacing_mm = 7.0;
  const std::vector<std::pair<std::string, Point3>> boxes = {
      {"cube", {20, 20, 20}}, {"low", {30, 40, 8}}, {"high", {10, 10, 40}}};
  std::map<std::string, double> single;
  for (const auto& [name, size] : boxes) {
    job_.plate.parts.clear();
    add(box(name, size));
    single[name] = depositedIn(run().sliced.toolpath);
  }
  job_.plate.parts.clear();
  for (const auto& [name, size] : boxes) add(folder_.file(name + ".stl"));
  const SlicedPlate plate = run();
  const auto spans = beltByPart(plate.sliced);
  ASSERT_EQ(spans.size(), 3U);
  EXPECT_NEAR(spans.at("low").first - spans.at("cube").second, 7.0, 1e-6);
  EXPECT_NEAR(spans.at("high").first - spans.at("low").second, 7.0, 1e-6);
  const auto deposited = volumesByPart(plate.sliced.toolpath);
  for (const auto& [name, volume_mm3] : single) EXPECT_NEAR(deposited.at(name), volume_mm3, 1e-6) << name;
  ASSERT_EQ(plate.parts.size(), 3U);
  EXPECT_LT(plate.parts[2].at_mm.y(), plate.parts[1].at_mm.y() - 20.0) << "the belt goes along -y";

  job_.plate.parts.front().at_mm = Point2(10, 10);
  EXPECT_NE(refusal().find("at_mm"), std::string::npos) << refusal();
}

TEST_F(PlateJobTest, PartsStandBesideEachOtherInInclinedLayers) {
  job_.settings.cooling.least_layer_time_s = 0.0;  // waits rise as well
  job_.settings.machine.name = "gantry_45";
  job_.settings.slicing.plane.angle_deg = 45.0;
  add(box("cube", {20, 20, 20}), Point2(70, 60));
  add(box("low", {30, 15, 5}), Point2(110, 75));
  const std::vector<PlatePart> both = job_.plate.parts;
  std::map<std::string, double> single;
  for (const PlatePart& part : both) {
    job_.plate.parts = {part};
    const SlicedPlate plate = run();
    single[plate.parts.front().name] = depositedIn(plate.sliced.toolpath);
  }
  job_.plate.parts = both;
  const SlicedPlate plate = run();
  const Toolpath& toolpath = plate.sliced.toolpath;
  const auto deposited = volumesByPart(toolpath);
  for (const auto& [name, volume_mm3] : single) EXPECT_NEAR(deposited.at(name), volume_mm3, 1e-6) << name;
  EXPECT_TRUE(hasPlaneLayers(toolpath));
  EXPECT_NEAR(inclinationDeg(toolpath), 45.0, 1e-9);
  double level_mm = -1e9;
  for (const ToolpathLayer& layer : inLayerFrame(toolpath).layers) {
    EXPECT_GE(layer.z_mm, level_mm) << "nothing is deposited below what is finished";
    level_mm = layer.z_mm;
    EXPECT_LE(greatestRise(layer), job_.settings.planning.travel.hop_mm + 1e-6) << level_mm;
  }
  const Box3 of_both = depositionBox(toolpath);
  EXPECT_GT(of_both.low.x(), 60.0);
  EXPECT_LT(of_both.low.x(), 60.5);
  EXPECT_GT(of_both.high.x(), 124.5);
  EXPECT_LT(of_both.high.x(), 125.0);

  job_.settings.plate.order = PlateOrder::ByPart;
  EXPECT_NE(refusal().find("plate.order is by_part in inclined layers"), std::string::npos) << refusal();
}

/// Keeps the names of what is being done.
class StagesSeen final : public Progress {
 public:
  void report(const std::string& stage, double) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    stages_.insert(stage);
  }
  bool isCancelled() const override { return false; }
  const std::set<std::string>& stages() const { return stages_; }

 private:
  std::mutex mutex_;
  std::set<std::string> stages_;
};

TEST_F(PlateJobTest, RefusesWhatInclinedLayersDoNotTakeBeforeItIsPlanned) {
  job_.settings.machine.name = "belt_45";
  job_.settings.slicing.plane.angle_deg = 45.0;
  add(box("a", {20, 20, 20}));
  add(box("b", {20, 20, 20}));
  job_.settings.planning.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  job_.settings.planning.tools.infill = 1;
  const auto refusalUnplanned = [this] {
    StagesSeen seen;
    try {
      runPlateJob(job_, seen);
    } catch (const InvalidConfig& error) {
      EXPECT_EQ(seen.stages().count("plan"), 0U);
      return std::string(error.what());
    }
    return std::string();
  };
  job_.settings.planning.tools.purge_mm3 = {40.0};
  const std::string tower = refusalUnplanned();
  EXPECT_NE(tower.find("tools.purge_mm3 is 40"), std::string::npos) << tower;
  EXPECT_NE(tower.find("slicing.plane.angle_deg 45"), std::string::npos) << tower;
  job_.settings.planning.tools.purge_mm3.clear();
  job_.settings.machine.name = "gantry_45";
  job_.settings.plate.order = PlateOrder::ByPart;
  const std::string by_part = refusalUnplanned();
  EXPECT_NE(by_part.find("plate.order is by_part in inclined layers"), std::string::npos) << by_part;
}

}  // namespace
}  // namespace lamina
