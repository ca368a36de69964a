// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/stack_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "counted_checks.hpp"
#include "job/modes/fit/plan_check.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kOverAllMm = 120.0;

Path travelOver(const Point3& from, const Point3& to) {
  Path travel = test::straightPath(from, to);
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.points = {from, {from.x(), from.y(), kOverAllMm}, {to.x(), to.y(), kOverAllMm}, to};
  return travel;
}

/// Upright beads, one a layer, over the middle of the bed.
Toolpath uprightBeads(const std::vector<std::pair<Point3, Point3>>& ends) {
  Toolpath toolpath;
  Point3 last(0, 0, kOverAllMm);
  for (const auto& [from, to] : ends) {
    Path bead = test::straightPath(from, to);
    bead.bead = Bead{1.0, to.z()};
    toolpath.layers.push_back({to.z(), to.z(), {travelOver(last, from), bead}});
    last = to;
  }
  return toolpath;
}

/// Low beads, the last of which leads below the head, over 50 mm wide, from a high one.
Toolpath lowBeadsBesideAHighOne() {
  return uprightBeads({{{-60, -60, 5}, {60, -60, 5}},
                       {{45, -45, 45}, {45, 45, 45}},
                       {{-60, 60, 5}, {-20, 60, 5}},
                       {{-60, 0, 5}, {40, 0, 5}}});
}

struct TiltingHeadPlan {
  TiltingHeadPlan() {
    job.settings.machine.name = "five_axis_head_table";
    job.settings.volumetric.largest_left_out_percent = 10.0;
    job.output = "beads.gcode";
  }

  StackFit fit(const Toolpath& planned) {
    const BuildSpace space = buildSpaceOf(job.settings.machine);
    const Box3 bed = boundingBox(space);
    const Point3 middle = 0.5 * (bed.low + bed.high);
    const PlanningRequest request{
        job, space,
        Eigen::Isometry3d(Eigen::Translation3d(middle.x(), middle.y(), std::max(0.0, bed.low.z())))};
    return fitStack(planned, kNothingStands, request, progress);
  }

  SliceJob job;
  test::CountedChecks progress;
};

TEST(StackFit, LeavesOutWhereTheHeadHasNoRoom) {
  TiltingHeadPlan plan;
  const Toolpath planned = lowBeadsBesideAHighOne();
  const StackFit fit = plan.fit(planned);
  const double left_out = totals(planned).deposited_mm3 - totals(fit.toolpath).deposited_mm3;
  EXPECT_GT(left_out, 0.0);
  EXPECT_LE(left_out, 0.10 * totals(planned).deposited_mm3);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_NE(fit.notes.back().find("are left out there"), std::string::npos) << fit.notes.back();
  EXPECT_EQ(toolpathId(plan.fit(fit.toolpath).toolpath), toolpathId(fit.toolpath)) << "it can be run";
}

/// A bead near the bed, with the tool axis leaning by an angle to its side all the way.
Toolpath beadLeaningAside(double lean_deg) {
  Toolpath toolpath = uprightBeads({{{-20, 0, 8}, {20, 0, 8}}});
  const Eigen::Quaterniond lean(Eigen::AngleAxisd(toRadians(lean_deg), Point3::UnitX()));
  for (Path& path : toolpath.layers.front().paths)
    path.orientation = AlongPath<Eigen::Quaterniond>(lean * Eigen::Quaterniond(0, 1, 0, 0));
  return toolpath;
}

// The head turns 120 mm above the tip, and reaches down to 20 mm above the bed: at 8 mm and 88 deg it would
// have to be at 12 mm.
TEST(StackFit, LeansLessWhereAJointWouldBeBeyondItsLimits) {
  TiltingHeadPlan plan;
  const Toolpath planned = beadLeaningAside(88.0);
  const StackFit fit = plan.fit(planned);
  ASSERT_FALSE(fit.notes.empty());
  EXPECT_NE(fit.notes.front().find("leans less than the layers ask"), std::string::npos) << fit.notes.front();
  EXPECT_NEAR(totals(fit.toolpath).deposited_mm3, totals(planned).deposited_mm3, 1e-9);
  const AlongPath<Eigen::Quaterniond>& held = fit.toolpath.layers.front().paths.back().orientation;
  const Point3 jet = held.at(0) * Point3::UnitZ();
  EXPECT_GE(8.0 - 120.0 * jet.z(), 20.0 - 1e-6);
  EXPECT_EQ(plan.progress.checks(), 4U) << "some layers and all, as planned and as raised";
}

TEST(StackFit, LeavesAsItIsWhatIsNotRefused) {
  const Toolpath planned = lowBeadsBesideAHighOne();
  const auto isLeft = [&](TiltingHeadPlan& plan) {
    const StackFit fit = plan.fit(planned);
    return fit.notes.empty() && toolpathId(fit.toolpath) == toolpathId(planned);
  };
  TiltingHeadPlan plan;
  plan.job.settings.clearance.need = ClearanceNeed::Never;
  EXPECT_TRUE(isLeft(plan));
  plan.job.settings.clearance.need = ClearanceNeed::Turning;
  plan.job.output.clear();
  EXPECT_TRUE(isLeft(plan)) << "the part is only tried";
  plan.job.output = "poses.csv";
  EXPECT_FALSE(isLeft(plan)) << "poses drive the machine as a program does";
}

TEST(StackFit, LeavesAsItIsWhatIsRefusedNevertheless) {
  TiltingHeadPlan plan;
  plan.job.settings.volumetric.largest_left_out_percent = 0.0;
  const Toolpath planned = lowBeadsBesideAHighOne();
  const StackFit fit = plan.fit(planned);
  EXPECT_TRUE(fit.notes.empty());
  EXPECT_EQ(toolpathId(fit.toolpath), toolpathId(planned));
  EXPECT_EQ(plan.progress.checks(), 3U) << "some layers, all as planned, all raised; what may not is not cut";
}

// Low beads beside a high one, all of which lead below the head.
TEST(StackFit, IsRefusedByPlaceAfterChecksOfSomeLayers) {
  TiltingHeadPlan plan;
  plan.job.settings.volumetric.largest_left_out_percent = 0.5;
  std::vector<std::pair<Point3, Point3>> ends = {{{45, -45, 45}, {45, 45, 45}}};
  for (int i = 0; i < 24; ++i) ends.push_back({{0, -24.0 + 2.0 * i, 5}, {40, -24.0 + 2.0 * i, 5}});
  try {
    plan.fit(uprightBeads(ends));
    FAIL() << "not refused";
  } catch (const Unreachable& refusal) {
    const std::string text = refusal.what();
    EXPECT_EQ(text.rfind("layer 5, path 1, waypoint ", 0), 0U) << text;
    EXPECT_NE(text.find("link 'head' is in what was deposited at layer 0, path 1"), std::string::npos)
        << text;
    EXPECT_NE(text.find("in 5 of 25 layers, the only ones that were looked at"), std::string::npos) << text;
    EXPECT_NE(text.find("(volumetric.largest_left_out_percent)"), std::string::npos) << text;
  }
  EXPECT_EQ(plan.progress.checks(), 2U) << "some layers, as planned and as raised";
}

TEST(StackFit, IsRefusedAfterOneCheckOfSomeLayersWhereAPlaceIsOutOfReach) {
  TiltingHeadPlan plan;
  Toolpath planned = lowBeadsBesideAHighOne();
  planned.layers[2].paths.back().points.front().x() = -1000.0;
  try {
    plan.fit(planned);
    FAIL() << "not refused";
  } catch (const Unreachable& refusal) {
    const std::string text = refusal.what();
    EXPECT_EQ(text.rfind("layer 2, path ", 0), 0U) << text;
    EXPECT_NE(text.find("in 2 of 4 layers, the only ones that were looked at: no leaning less"),
              std::string::npos)
        << text;
  }
  EXPECT_EQ(plan.progress.checks(), 1U);
}

// Raising has its own way there, and axes that are led may stand elsewhere in the whole.
TEST(StackFit, APlaceOutOfReachOfSomeLayersIsLeftToTheCheckOfTheWhole) {
  Toolpath planned = lowBeadsBesideAHighOne();
  planned.layers[2].paths.back().points.front().x() = 4000.0;
  const auto isLeft = [&](const auto& change) {
    TiltingHeadPlan plan;
    plan.job.settings.volumetric.largest_left_out_percent = 100.0;
    change(plan.job.settings);
    try {
      return toolpathId(plan.fit(planned).toolpath) == toolpathId(planned);
    } catch (const Unreachable&) {
      return false;
    }
  };
  EXPECT_FALSE(isLeft([](JobSettings&) {}));
  EXPECT_TRUE(isLeft([](JobSettings& settings) { settings.clearance.raises_tool_axis = true; }));
  const auto useTurntable = [](JobSettings& settings) { settings.machine.name = "irb_4600_turntable"; };
  EXPECT_FALSE(isLeft(useTurntable));
  EXPECT_TRUE(isLeft([&](JobSettings& settings) {
    useTurntable(settings);
    settings.joints.external = ExternalChoice::Follow;
  }));
}

class FittedStack : public testing::Test {
 protected:
  FittedStack() {
    JobSettings& settings = job_.settings;
    settings.machine.name = "five_axis_head_table";
    settings.slicing.layer_height_mm = settings.slicing.first_layer_height_mm = 0.4;
    settings.cooling.least_layer_time_s = 0.0;
  }

  SlicedPart slice(const std::string& mode, const std::string& output) {
    job_.settings.slicing.mode = mode;
    job_.output = folder_.file(output);
    NoProgress nobody;
    return runSliceJob(job_, nobody);
  }

  static bool isNoted(const SlicedPart& sliced, const std::string& words) {
    const std::vector<std::string>& notes = sliced.summary.notes;
    return std::any_of(notes.begin(), notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
  }

  void usePart(const std::string& name, const std::vector<SettingText>& parameters) {
    job_.part = folder_.file(name + ".stl");
    writeStl(job_.part, makePart(name, parameters));
  }

  test::ScratchFolder folder_;
  SliceJob job_;
};

Point3 toolAxisAt(const Path& path, std::size_t waypoint) {
  return path.orientation.at(waypoint) * Point3::UnitZ();
}

// Its sides lean by less than 5 deg, so that the table follows the azimuth of tool axes that are nearly
// upright.
TEST_F(FittedStack, NearlyUprightToolAxesOfAdaptedLayersAreSettled) {
  usePart("blade", {{"height_mm", "10"}, {"chord_mm", "16"}});
  job_.settings.clearance.need = ClearanceNeed::Never;
  const Toolpath planned = slice("adapted", "poses.csv").toolpath;
  job_.settings.clearance.need = ClearanceNeed::Turning;
  const SlicedPart fitted = slice("adapted", "blade.gcode");
  EXPECT_TRUE(std::filesystem::exists(job_.output));
  EXPECT_TRUE(isNoted(fitted, "nearly upright"));
  ASSERT_EQ(fitted.toolpath.layers.size(), planned.layers.size());
  double greatest = 0.0;
  for (std::size_t l = 0; l < planned.layers.size(); ++l) {
    ASSERT_EQ(fitted.toolpath.layers[l].paths.size(), planned.layers[l].paths.size()) << l;
    for (std::size_t p = 0; p < planned.layers[l].paths.size(); ++p) {
      const Path& before = planned.layers[l].paths[p];
      const Path& after = fitted.toolpath.layers[l].paths[p];
      ASSERT_EQ(after.points, before.points);
      for (std::size_t w = 0; w < before.points.size(); ++w)
        greatest = std::max(greatest, (toolAxisAt(after, w) - toolAxisAt(before, w)).norm());
    }
  }
  EXPECT_GT(greatest, 0.0);
  EXPECT_LE(greatest, 2.0 * std::sin(0.5 * M_PI / 180.0) + 1e-9) << "by 1 deg at most";
}

// About its pole, a coat's tool axes point every way.
TEST_F(FittedStack, TheNozzleTurnsOffTheBeadsOfACoatAtItsPole) {
  usePart("sphere", {{"radius_mm", "10"}});
  job_.settings.clearance.need = ClearanceNeed::Never;
  const SlicedPart planned = slice("conformal", "poses.csv");
  job_.settings.clearance.need = ClearanceNeed::Turning;
  const SlicedPart fitted = slice("conformal", "sphere.gcode");
  EXPECT_TRUE(std::filesystem::exists(job_.output));
  EXPECT_GE(fitted.summary.deposited_mm3, 0.995 * planned.summary.deposited_mm3);
  EXPECT_TRUE(isNoted(fitted, "nearly upright") || isNoted(fitted, "turns off the bead"));
}

}  // namespace
}  // namespace lamina
