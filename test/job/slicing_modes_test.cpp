// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "support/grown_parts.hpp"
#include "support/scoped_entry.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class SlicingModes : public ::testing::Test {
 protected:
  SlicingModes() {
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.bead.width_mm = 0.8;
    job_.settings.planning.walls.count = 1;
    job_.settings.planning.infill.density = 1.0;
  }

  void usePart(const std::string& name, const std::vector<SettingText>& parameters) {
    job_.part = folder_.file(name + ".stl");
    writeStl(job_.part, makePart(name, parameters));
  }

  /// A flat cone, 26.6 deg steep.
  void useDome() { usePart("cone", {{"radius_mm", "20"}, {"height_mm", "10"}}); }

  SlicedPart slice(const std::string& mode) {
    job_.settings.slicing.mode = mode;
    NoProgress nobody;
    return runSliceJob(job_, nobody);
  }

  test::ScratchFolder folder_;
  SliceJob job_;
};

double greatestLeanDeg(const Toolpath& toolpath) {
  double greatest = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t w = 0; w < path.points.size(); ++w) {
        const Point3 tool_axis = path.orientation.at(w) * Point3::UnitZ();
        greatest = std::max(greatest, std::atan2(tool_axis.head<2>().norm(), -tool_axis.z()) * 180.0 / M_PI);
      }
  return greatest;
}

TEST_F(SlicingModes, CurvedLayersFillASphere) {
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "64"}});
  const SlicedPart sliced = slice("curved");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  // 7 mm of half a millimetre on each side; the innermost, 0.25 mm in radius, has no room for a bead.
  EXPECT_EQ(sliced.summary.layers, 26U);
  EXPECT_NEAR(sliced.summary.sliced_volume_mm3, sliced.summary.mesh_volume_mm3,
              0.02 * sliced.summary.mesh_volume_mm3);
  EXPECT_NEAR(sliced.summary.deposited_mm3, sliced.summary.mesh_volume_mm3,
              0.10 * sliced.summary.mesh_volume_mm3);
  EXPECT_GT(greatestLeanDeg(sliced.toolpath), 80.0);
  EXPECT_NEAR(sliced.summary.orientation.lean_deg.value, greatestLeanDeg(sliced.toolpath), 1e-6);
}

/// Of what is deposited, against layers without gaps.
double solidShare(const SlicedPart& sliced) {
  return sliced.summary.deposited_mm3 / sliced.summary.sliced_volume_mm3;
}

TEST_F(SlicingModes, ACoatIsSolidWhateverTheInfill) {
  useDome();
  job_.settings.planning.infill.density = 0.2;
  job_.settings.conformal.thickness_mm = 2.0;
  job_.settings.planning.skins.bottom_layers = 2;
  job_.settings.planning.skins.top_layers = 2;
  EXPECT_GT(solidShare(slice("conformal")), 0.9);
  job_.settings.planning.skins.top_layers = 0;
  const double half = solidShare(slice("conformal"));
  EXPECT_LT(half, 0.8);
  job_.settings.planning.skins.bottom_layers = 0;
  EXPECT_LT(solidShare(slice("conformal")), half - 0.1);
}

TEST_F(SlicingModes, ShellsOfCurvedLayersAreSkins) {
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "64"}});
  job_.settings.planning.infill.density = 0.2;
  job_.settings.planning.skins.bottom_layers = 0;
  job_.settings.planning.skins.top_layers = 0;
  const double sparse = slice("curved").summary.deposited_mm3;
  job_.settings.planning.skins.bottom_layers = 3;
  job_.settings.planning.skins.top_layers = 3;
  const SlicedPart sliced = slice("curved");
  // Nothing of a solid shell is left for a refusal or a gap: what its lattice lacked is there.
  EXPECT_GT(sliced.summary.deposited_mm3, sparse + 0.1 * sliced.summary.sliced_volume_mm3);
}

TEST_F(SlicingModes, BentLayersKeepTheNozzleUprightAndTheVolume) {
  usePart("cone", {{"radius_mm", "20"}, {"top_radius_mm", "1"}, {"height_mm", "5"}});
  job_.output = folder_.file("cone.gcode");
  const SlicedPart sliced = slice("heightfield");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  EXPECT_LT(greatestLeanDeg(sliced.toolpath), 1e-6);
  EXPECT_NEAR(sliced.summary.deposited_mm3, sliced.summary.mesh_volume_mm3,
              0.05 * sliced.summary.mesh_volume_mm3);
  EXPECT_FALSE(sliced.summary.notes.empty());
  EXPECT_TRUE(std::filesystem::exists(job_.output));
}

TEST_F(SlicingModes, AdaptedLayersGrowAlongALeaningWall) {
  const double lean = 30.0 * M_PI / 180.0;
  usePart("cone", {{"radius_mm", "20"},
                   {"top_radius_mm", std::to_string(20.0 + 10.0 * std::tan(lean))},
                   {"height_mm", "10"},
                   {"segments", "256"}});
  job_.settings.planning.infill.density = 0.0;
  const SlicedPart sliced = slice("adapted");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  EXPECT_NEAR(greatestLeanDeg(sliced.toolpath), 30.0, 0.5);
  // h cos 30 deg from one layer to the next.
  const double first = sliced.toolpath.layers[5].z_mm;
  EXPECT_NEAR(sliced.toolpath.layers[6].z_mm - first, 0.5 * std::cos(lean), 2e-3);
  EXPECT_LT(sliced.summary.lean.greatest_rad, 1.0 * M_PI / 180.0);
}

TEST_F(SlicingModes, AdaptedLayersCanBeFilled) {
  usePart("cone", {{"radius_mm", "10"}, {"top_radius_mm", "13"}, {"height_mm", "6"}});
  const SlicedPart sliced = slice("adapted");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  EXPECT_NEAR(sliced.summary.deposited_mm3, sliced.summary.mesh_volume_mm3,
              0.08 * sliced.summary.mesh_volume_mm3);
}

// About the rim of its foot, a wall that leans by 60 deg gets layers tilted by 60 - 25 deg.
TEST_F(SlicingModes, VolumetricLayersTiltWhereAWallWouldHang) {
  usePart("cone", {{"radius_mm", "6"}, {"top_radius_mm", "13"}, {"height_mm", "4"}});
  job_.settings.machine.name = "five_axis_head_table";
  job_.settings.volumetric.deviation_deg = 0.0;
  job_.settings.volumetric.overhang_used_deg = 25.0;  // whatever room the head has
  const SlicedPart sliced = slice("volumetric");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  EXPECT_NEAR(greatestLeanDeg(sliced.toolpath), 35.0, 3.0);
  EXPECT_NEAR(sliced.summary.deposited_mm3, sliced.summary.mesh_volume_mm3,
              0.10 * sliced.summary.mesh_volume_mm3);
  const std::string id = toolpathId(sliced.toolpath);
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(slice("volumetric").toolpath), id);
}

TEST_F(SlicingModes, VolumetricLayersOfABoxAreThoseOfPlanar) {
  usePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4.2"}});
  job_.settings.planning.skirt.count = 0;
  job_.settings.planning.bridges.is_used = job_.settings.planning.overhangs.is_used = false;
  job_.settings.planning.skins.top_layers = job_.settings.planning.skins.bottom_layers = 0;
  const SlicedPart grown = slice("volumetric");
  const SlicedPart planar = slice("planar");
  EXPECT_LT(greatestLeanDeg(grown.toolpath), 1e-9);
  ASSERT_EQ(grown.toolpath.layers.size(), planar.toolpath.layers.size());
  for (std::size_t i = 0; i < planar.toolpath.layers.size(); ++i)
    EXPECT_EQ(grown.toolpath.layers[i].z_mm, planar.toolpath.layers[i].z_mm);
  EXPECT_NEAR(grown.summary.deposited_mm3, planar.summary.deposited_mm3, 1e-6);
}

// The underside between the pillars hangs over level layers, and over none that lean by more than 45 deg.
TEST_F(SlicingModes, PiecesAlongTheirDirectionsMakeThePart) {
  usePart("bridge",
          {{"length_mm", "16"}, {"width_mm", "6"}, {"gap_mm", "6"}, {"pillar_mm", "8"}, {"plate_mm", "3"}});
  job_.settings.planning.skirt.count = 0;
  const SlicedPart sliced = slice("multi_direction");
  EXPECT_NO_THROW(validate(sliced.toolpath));
  EXPECT_GT(greatestLeanDeg(sliced.toolpath), 45.0);
  EXPECT_NEAR(sliced.summary.deposited_mm3, sliced.summary.mesh_volume_mm3,
              0.10 * sliced.summary.mesh_volume_mm3);
  const std::string id = toolpathId(sliced.toolpath);
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(slice("multi_direction").toolpath), id);
}

TEST_F(SlicingModes, APieceThatEndsInACornerLeavesNoLayerEmpty) {
  usePart("tee", {{"stem_mm", "12"},
                  {"stem_height_mm", "25"},
                  {"bar_mm", "50"},
                  {"bar_height_mm", "8"},
                  {"width_mm", "12"}});
  job_.settings.machine.name = "five_axis_head_table";
  job_.settings.slicing.layer_height_mm = 0.4;
  job_.settings.slicing.first_layer_height_mm = 0.4;
  const SlicedPart sliced = slice("multi_direction");
  EXPECT_GT(greatestLeanDeg(sliced.toolpath), 45.0);
  EXPECT_EQ(sliced.summary.empty_layers, 0U) << "no piece hangs in the air";
  EXPECT_EQ(sliced.summary.layers, sliced.toolpath.layers.size());
}

TEST_F(SlicingModes, PiecesOfABoxAreThatOfPlanar) {
  usePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4.2"}});
  job_.settings.planning.skirt.count = 0;
  const SlicedPart directed = slice("multi_direction");
  const SlicedPart planar = slice("planar");
  EXPECT_LT(greatestLeanDeg(directed.toolpath), 1e-9);
  ASSERT_EQ(directed.toolpath.layers.size(), planar.toolpath.layers.size());
  EXPECT_NEAR(directed.summary.deposited_mm3, planar.summary.deposited_mm3,
              0.01 * planar.summary.deposited_mm3);
}

TEST_F(SlicingModes, ACoatLiesOnThePart) {
  usePart("sphere", {{"radius_mm", "10"}, {"segments", "64"}});
  job_.settings.conformal.thickness_mm = 1.0;
  job_.settings.conformal.max_tilt_deg = 40.0;
  const SlicedPart sliced = slice("conformal");
  EXPECT_EQ(sliced.summary.layers, 2U);
  const Point3 centre(0.0, 0.0, 10.0);
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& tip : path.points) {
          EXPECT_GT((tip - centre).norm(), 10.3);
          EXPECT_LT((tip - centre).norm(), 11.05);
        }
}

TEST_F(SlicingModes, AProgramForAFixedHeadThatWouldHaveToTiltIsRefused) {
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}});
  job_.output = folder_.file("sphere.gcode");
  EXPECT_THROW(slice("curved"), Unreachable);
  EXPECT_FALSE(std::filesystem::exists(job_.output));
}

TEST_F(SlicingModes, ABowlThatAHeadHasNoRoomForIsRefusedUnlessMoreMayBeLeftOut) {
  usePart("sphere", {{"radius_mm", "5"}, {"segments", "32"}});
  job_.output = folder_.file("sphere.gcode");
  job_.settings.machine.name = "five_axis_head_table";
  try {
    slice("curved");
    ADD_FAILURE() << "not refused";
  } catch (const Unreachable& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("(volumetric.largest_left_out_percent)"), std::string::npos)
        << refusal.what();
  }
  EXPECT_FALSE(std::filesystem::exists(job_.output));
}

TEST_F(SlicingModes, AnUprightNozzleMayLayShellsThatAreNotTooSteep) {
  job_.output = folder_.file("part.gcode");
  job_.settings.orientation.mode = OrientationMode::Fixed;
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}});
  EXPECT_THROW(slice("curved"), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(job_.output));
  useDome();
  EXPECT_NO_THROW(slice("curved"));
  EXPECT_TRUE(std::filesystem::exists(job_.output));
}

TEST_F(SlicingModes, ARefusalShowsTheRegionOnThePart) {
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}});
  try {
    slice("adapted");
    FAIL() << "a sphere has no walls";
  } catch (const Unsliceable& refusal) {
    EXPECT_FALSE(refusal.region().triangles.empty());
    EXPECT_NEAR(volume(refusal.part()), 4.0 / 3.0 * M_PI * 343.0, 30.0);
  }
}

TEST_F(SlicingModes, SettingsThatDoNotGoTogetherAreRefused) {
  usePart("box", {});
  EXPECT_THROW(slice("inclined"), InvalidConfig);
  job_.settings.slicing.plane.angle_deg = 45.0;
  EXPECT_THROW(slice("curved"), InvalidConfig);
  job_.settings.slicing.plane.angle_deg = 0.0;
  job_.settings.scan.every_layers = 1;
  EXPECT_THROW(slice("heightfield"), InvalidConfig);
  job_.settings.scan.every_layers = 0;
  job_.settings.planning.skirt.count = 3;
  EXPECT_THROW(slice("curved"), InvalidConfig);
  job_.settings.planning.skirt.count = 0;
  job_.settings.planning.infill.strategy = "vase";
  EXPECT_THROW(slice("curved"), InvalidConfig);
  job_.settings.planning.infill.strategy = "zigzag";
  job_.settings.slicing.first_layer_height_mm = 0.4;
  EXPECT_THROW(slice("curved"), InvalidConfig);
}

TEST_F(SlicingModes, ShellsThatBeginInTheAirAreReported) {
  usePart("sphere", {{"radius_mm", "7"}, {"segments", "32"}});
  const auto isReported = [](const SliceSummary& summary) {
    return std::any_of(summary.notes.begin(), summary.notes.end(), [](const std::string& note) {
      return note.find("deposited on air") != std::string::npos;
    });
  };
  EXPECT_TRUE(isReported(slice("curved").summary));
  useDome();
  EXPECT_FALSE(isReported(slice("curved").summary));
}

TEST_F(SlicingModes, TheNozzleComesToACoatFromAbove) {
  usePart("box", {});
  job_.output = folder_.file("coat.gcode");
  const SlicedPart sliced = slice("conformal");
  const Path& approach = sliced.toolpath.layers.front().paths.front();
  EXPECT_EQ(approach.role, PathRole::Travel);
  double highest = 0.0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points) highest = std::max(highest, point.z());
  EXPECT_DOUBLE_EQ(approach.firstPoint().z(), highest);
  const std::string program = readFile(job_.output);
  const std::size_t start = program.find("; start of the part\nG0 Z");
  EXPECT_NE(start, std::string::npos) << "up before it goes over the part";
}

TEST_F(SlicingModes, LayersOnABaseStandWithItOnTheBed) {
  Mesh base = makePart("box", {});
  Mesh plate = base;
  const double top = boundingBox(base).high.z();
  for (Point3& vertex : plate.vertices) vertex.z() = vertex.z() > 0.5 * top ? top + 2.0 : top;
  job_.part = folder_.file("plate.stl");
  writeStl(job_.part, plate);
  job_.settings.conformal.base = folder_.file("base.stl");
  writeStl(job_.settings.conformal.base, base);
  const SlicedPart sliced = slice("conformal");
  EXPECT_EQ(sliced.summary.layers, 4U);
  EXPECT_NEAR((sliced.bed_from_part * Point3(0.0, 0.0, top)).z(), top, 1e-9) << "the base stands on the bed";
}

TEST_F(SlicingModes, GiveTheSameOnAnyNumberOfThreads) {
  usePart("sphere", {{"radius_mm", "5"}, {"segments", "32"}});
  const std::string id = toolpathId(slice("curved").toolpath);
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(slice("curved").toolpath), id);
}

TEST_F(SlicingModes, AnAddedModeIsChosenByItsName) {
  SlicingMode lowest;
  lowest.plan = [](SourcePart source, const PlanningRequest& request, Progress& progress) {
    PlannedPart planned = slicingModes().find("planar").plan(std::move(source), request, progress);
    planned.plan.toolpath.layers.resize(3);
    planned.counts.layers = 3;
    return planned;
  };
  lowest.shape = LayerShape::Plane;
  const test::ScopedEntry<SlicingMode> entry(slicingModes(), "lowest", lowest);
  useDome();
  const JobSettings loaded = loadJobSettings("", {{"slicing.mode", "lowest"}});
  const SlicedPart sliced = slice(loaded.slicing.mode);
  EXPECT_EQ(sliced.toolpath.layers.size(), 3U);
  EXPECT_EQ(sliced.summary.mode, "lowest");
}

TEST_F(SlicingModes, AnUnknownOneIsRefusedNamingThoseThereAre) {
  try {
    loadJobSettings("", {{"slicing.mode", "wavy"}});
    FAIL() << "nothing thrown";
  } catch (const InvalidConfig& error) {
    for (const std::string& name : slicingModeNames())
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

/// Whether beads of a layer lie over a place, seen from above.
bool isBeadOver(const ToolpathLayer& layer, const Point2& place, double reach_mm) {
  for (const Path& path : layer.paths) {
    if (path.role == PathRole::Travel) continue;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Point2 from = path.points[i - 1].head<2>();
      const Point2 along = path.points[i].head<2>() - from;
      const double share = along.squaredNorm() > 0.0 ? (place - from).dot(along) / along.squaredNorm() : 0.0;
      if ((from + std::clamp(share, 0.0, 1.0) * along - place).norm() <= reach_mm) return true;
    }
  }
  return false;
}

/// The share of the step's top, x from 6.8 to 19.2 and y from -4.2 to 4.2, that a layer leaves open: without
/// a bead's middle within three quarters of its width.
double openOnStep(const ToolpathLayer& layer, double bead_mm) {
  int open = 0;
  int places = 0;
  for (double x = 6.8; x < 19.2; x += 0.25)
    for (double y = -4.2; y < 4.2; y += 0.25, ++places)
      if (!isBeadOver(layer, {x, y}, 0.75 * bead_mm)) ++open;
  return static_cast<double>(open) / places;
}

/// A step of 14 mm, 5 mm high, beside a limb that goes on to 12 mm: its top lies amid the stack.
TEST_F(SlicingModes, StepsBelowHigherLimbsAreClosedInEveryMode) {
  job_.part = folder_.file("step.stl");
  writeStl(job_.part, test::lyingPrism({{{0, 0}, {20, 0}, {20, 5}, {6, 5}, {6, 12}, {0, 12}}, {}}, 10.0));
  job_.settings.planning.infill.density = 0.2;
  for (const char* mode : {"planar", "volumetric", "curved", "heightfield"}) {
    job_.settings.planning.skins.top_layers = job_.settings.planning.skins.bottom_layers = 3;
    const Toolpath closed = slice(mode).toolpath;
    ASSERT_EQ(closed.layers.size(), 24U) << mode;
    for (const std::size_t layer : {7U, 8U, 9U})
      EXPECT_EQ(openOnStep(closed.layers[layer], 0.8), 0.0) << mode << ", layer " << layer;
    EXPECT_GT(openOnStep(closed.layers[6], 0.8), 0.3) << mode << ": four layers below the top";
    job_.settings.planning.skins.top_layers = job_.settings.planning.skins.bottom_layers = 0;
    EXPECT_GT(openOnStep(slice(mode).toolpath.layers[9], 0.8), 0.3) << mode << ": no skins";
  }
}

/// Amid a box nothing is seen but walls.
TEST_F(SlicingModes, SkinsOfVolumetricLayersGoNoFartherThanWhatIsSeen) {
  usePart("box", {{"x_mm", "16"}, {"y_mm", "12"}, {"z_mm", "12.5"}});
  job_.settings.planning.infill.density = 0.2;
  job_.settings.planning.skins.top_layers = job_.settings.planning.skins.bottom_layers = 3;
  const SlicedPart sliced = slice("volumetric");
  ASSERT_EQ(sliced.toolpath.layers.size(), 25U);
  for (std::size_t layer = 3; layer < 22; ++layer)
    for (const Path& path : sliced.toolpath.layers[layer].paths)
      EXPECT_TRUE(path.role == PathRole::OuterWall || path.role == PathRole::Infill ||
                  path.role == PathRole::Travel)
          << layer << ": " << toString(path.role);
  for (const std::string& note : sliced.summary.notes)
    EXPECT_EQ(note.find("skins close"), std::string::npos) << note;
}

/// The plate of a bridge grows from both pillars, and the fronts meet in a fold that the nozzle's cone does
/// not enter: what lies there is left out, if so much may be, and the machine then runs the rest.
TEST_F(SlicingModes, VolumetricLayersLeaveOutWhatTheHeadHasNoRoomFor) {
  usePart("bridge",
          {{"length_mm", "16"}, {"width_mm", "6"}, {"gap_mm", "6"}, {"pillar_mm", "8"}, {"plate_mm", "3"}});
  job_.settings.machine.name = "five_axis_head_table";
  job_.settings.planning.bead.width_mm = 1.0;
  job_.settings.volumetric.cell_mm = 0.5;
  job_.settings.volumetric.overhang_used_deg = 10.0;
  const auto model = kinematicModelOf(job_.settings.machine);
  const auto checked = [&](const SlicedPart& sliced) {
    NoProgress nobody;
    return checkRun(runOn(*model, sliced.toolpath, sliced.bed_from_part, job_.settings.joints, nobody),
                    *model, job_.settings.clearance, nobody);
  };
  job_.settings.volumetric.largest_left_out_percent = 0.0;
  const SlicedPart whole = slice("volumetric");
  EXPECT_FALSE(checked(whole).isClear());
  job_.settings.volumetric.largest_left_out_percent = 10.0;
  const SlicedPart fitted = slice("volumetric");
  EXPECT_TRUE(checked(fitted).isClear());
  const double left_out = whole.summary.deposited_mm3 - fitted.summary.deposited_mm3;
  EXPECT_GT(left_out, 0.0);
  EXPECT_LT(left_out, 0.1 * whole.summary.deposited_mm3);
}

}  // namespace
}  // namespace lamina
