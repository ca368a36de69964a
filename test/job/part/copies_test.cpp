// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/copies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// A cube of 20 mm in layers at 45 deg on a belt.
SliceJob cubes(int count, const std::string& output = "") {
  SliceJob job;
  job.part = "box";
  job.output = output;
  job.settings.machine.name = "belt_45";
  job.settings.slicing.plane.angle_deg = 45.0;
  job.settings.slicing.layer_height_mm = 1.0;
  job.settings.slicing.first_layer_height_mm = 1.0;
  job.settings.planning.bead.width_mm = 1.2;
  job.settings.copies.count = count;
  job.settings.copies.spacing_mm = 7.0;
  return job;
}

SlicedPart copiesRun(const SliceJob& job) {
  NoProgress nobody;
  return runSliceJob(job, nobody);
}

/// Values of the belt over what is deposited.
struct Span {
  double low = 1e9;
  double high = -1e9;
};

Span beltSpan(const SlicedPart& sliced, std::size_t from_layer, std::size_t to_layer) {
  const CartesianMachine machine = machineByName("belt_45");
  Span span;
  for (std::size_t l = from_layer; l < to_layer; ++l)
    for (const Path& path : sliced.toolpath.layers[l].paths) {
      if (path.role == PathRole::Travel) continue;
      for (const Point3& point : path.points) {
        const double belt = axisValues(machine, sliced.bed_from_part * point).z();
        span.low = std::min(span.low, belt);
        span.high = std::max(span.high, belt);
      }
    }
  return span;
}

TEST(Copies, FollowEachOtherAlongTheBeltAndAreAlike) {
  const SlicedPart one = copiesRun(cubes(1));
  const SlicedPart three = copiesRun(cubes(3));
  const std::size_t layers = one.toolpath.layers.size();
  ASSERT_EQ(three.toolpath.layers.size(), 3 * layers);
  EXPECT_NO_THROW(validate(three.toolpath));
  EXPECT_NEAR(totals(three.toolpath).deposited_mm3, 3.0 * totals(one.toolpath).deposited_mm3, 1e-6);
  for (std::size_t copy = 1; copy < 3; ++copy) {
    const Span before = beltSpan(three, (copy - 1) * layers, copy * layers);
    const Span after = beltSpan(three, copy * layers, (copy + 1) * layers);
    EXPECT_NEAR(after.low - before.high, 7.0, 1e-9);
    EXPECT_NEAR(after.high - after.low, before.high - before.low, 1e-9);
  }
  // On the belt the copies stand in one line.
  const Path& first = three.toolpath.layers[0].paths.back();
  const Path& second = three.toolpath.layers[layers].paths.back();
  const Point3 step = second.points[0] - first.points[0];
  EXPECT_NEAR(step.x(), 0.0, 1e-12);
  EXPECT_NEAR(step.z(), 0.0, 1e-12);
  EXPECT_LT(step.y(), -20.0) << "the belt runs towards +y, so that copies come from -y";
  const Point3 normal = layerNormal(three.toolpath);
  for (const ToolpathLayer& layer : three.toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) {
        ASSERT_NEAR(normal.dot(path.points[0]), layer.z_mm, 1e-6);
      }
}

TEST(Copies, TheBeltGoesOnBeforeTheNozzleGoesAcross) {
  const SlicedPart two = copiesRun(cubes(2));
  const std::size_t layers = two.toolpath.layers.size() / 2;
  const Path& travel = two.toolpath.layers[layers].paths.front();
  ASSERT_EQ(travel.role, PathRole::Travel);
  EXPECT_TRUE(travel.process.is_retracted);
  const CartesianMachine machine = machineByName("belt_45");
  const auto axesAt = [&](const Point3& point) { return axisValues(machine, two.bed_from_part * point); };
  // In the wait at the end of the first copy the belt goes on already.
  const std::vector<Path>& before = two.toolpath.layers[layers - 1].paths;
  const auto bead = std::find_if(before.rbegin(), before.rend(),
                                 [](const Path& path) { return path.role != PathRole::Travel; });
  const AxisValues start = axesAt(bead->lastPoint());
  const AxisValues amid = axesAt(travel.points[1]);
  EXPECT_LT((amid - start).head<2>().norm(), 1e-9);
  EXPECT_NEAR(amid.z() - start.z(), 7.0, 1e-4);
  EXPECT_NEAR(axesAt(travel.points.back()).z(), amid.z(), 1e-9);
}

TEST(Copies, StandInTheProgram) {
  const test::ScratchFolder folder;
  const SlicedPart two = copiesRun(cubes(2, folder.file("two.gcode")));
  const Toolpath read = toolpathFromGcodeFile(folder.file("two.gcode"), ProgramSettings{});
  EXPECT_EQ(read.layers.size(), two.toolpath.layers.size());
  EXPECT_NEAR(depositionBox(read).size().y(), depositionBox(two.toolpath).size().y(), 5e-3);
}

TEST(Copies, NeedABelt) {
  SliceJob job = cubes(2);
  job.settings.machine.name = "gantry_45";
  try {
    copiesRun(job);
    FAIL() << "a plate has no room that never ends";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("part.copies is 2"), std::string::npos) << error.what();
  }
}

/// A bead of 10 mm across the belt, y mm along it.
Toolpath beadAt(double y) {
  Path bead;
  bead.role = PathRole::OuterWall;
  bead.points = {{0, y, 0}, {10, y, 0}};
  bead.bead = Bead{1.2, 1.0};
  bead.feed_mm_s = 20.0;
  return {"bead", {{0.0, 1.0, {bead}}}};
}

TEST(BeltParts, ThatDepositNothingAreLeftOut) {
  const BuildSpace space = buildSpaceByName("belt_45");
  const Toolpath nothing{"nothing", {{0.0, 1.0, {}}}};
  const Toolpath bead = beadAt(0.0);
  const std::vector<BeltPart> parts = {
      {"first", &nothing}, {"second", &bead}, {"third", &nothing}, {"fourth", &bead}};
  const std::vector<Point3> places = placesAlongBelt(parts, 7.0, space);
  ASSERT_EQ(places.size(), 4U);
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(places[i], Point3(0, 0, 0)) << i;
  EXPECT_NEAR(places[3].norm(), 7.0, 1e-9);
  const Toolpath all = oneAfterAnother(parts, places, space, 100.0);
  ASSERT_EQ(all.layers.size(), 2U);
  std::vector<std::string> marks;
  for (const ToolpathLayer& layer : all.layers)
    for (const Path& path : layer.paths)
      for (const PathEvent& event : path.events)
        if (const auto* mark = std::get_if<PartMark>(&event.event)) marks.push_back(mark->name);
  EXPECT_EQ(marks, (std::vector<std::string>{"second", "fourth"}));
  EXPECT_TRUE(oneAfterAnother({parts[0]}, {places[0]}, space, 100.0).layers.empty());
}

}  // namespace
}  // namespace lamina
