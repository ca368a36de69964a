// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The machines that come with Lamina, and parts sliced for them.
#include <gtest/gtest.h>

#include "lamina/base/parallel.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/verification/collision/clearance.hpp"

namespace lamina {
namespace {

SliceJob coarse(const std::string& part, const std::string& machine) {
  SliceJob job;
  job.part = part;
  job.settings.machine.name = machine;
  job.settings.slicing.layer_height_mm = 0.4;
  job.settings.slicing.first_layer_height_mm = 0.4;
  job.settings.planning.bead.width_mm = 0.8;
  return job;
}

ClearanceReport check(const SlicedPart& sliced, const std::string& machine) {
  NoProgress nobody;
  const CartesianMachine described = machineByName(machine);
  return checkClearance({sliced.toolpath, sliced.bed_from_part, described}, ClearanceSettings(), nobody);
}

SlicedPart run(const SliceJob& job) {
  NoProgress nobody;
  return runSliceJob(job, nobody);
}

TEST(PartClearance, ABoxInLevelLayersNeverMeetsAnUprightHead) {
  for (const std::string machine : {"cartesian_gantry", "drop_printer"}) {
    const ClearanceReport report = check(run(coarse("box", machine)), machine);
    EXPECT_EQ(report.colliding, 0U) << machine;
    EXPECT_GT(report.waypoints, 1000U);
  }
}

TEST(PartClearance, HeadsAt45DegreesClearTheLayersTheyAreMadeFor) {
  for (const auto& [machine, heading] : {std::pair{"gantry_45", 0.0},
                                         {"large_gantry_45", 0.0},
                                         {"large_gantry_45_reverse", 180.0},
                                         {"belt_45", 0.0}}) {
    SliceJob job = coarse("tube", machine);
    job.settings.slicing.plane = {45.0, heading, ToolAxis::Normal};
    const ClearanceReport report = check(run(job), machine);
    EXPECT_EQ(report.colliding, 0U) << machine;
    EXPECT_GT(report.waypoints, 1000U);
  }
}

TEST(PartClearance, AnUprightHeadClearsLayersUpToTheAngleOfItsBlock) {
  // The block is 20 mm wide to each side from 25 mm over the tip: it meets a slope of atan(25 / 20) = 51.3
  // deg. A part of 40 mm has room for both.
  for (const auto& [angle, collides] : {std::pair{51.0, false}, {52.0, true}}) {
    SliceJob job = coarse("box", "cartesian_gantry");
    job.settings.input.units.scale = 2.0;
    job.settings.planning.infill.density = 0.05;
    job.settings.slicing.plane = {angle, 0.0, ToolAxis::Down};
    const ClearanceReport report = check(run(job), "cartesian_gantry");
    EXPECT_EQ(report.colliding > 0U, collides) << angle;
    for (const Collision& first : report.first_of_layers) EXPECT_EQ(first.link, "head");
  }
}

TEST(PartClearance, ANozzleHeldDownMeetsSteepLayersAndTheFirstPlaceIsTheSameWhateverTheThreads) {
  SliceJob job = coarse("box", "cartesian_gantry");
  job.settings.slicing.plane = {75.0, 0.0, ToolAxis::Down};
  const SlicedPart sliced = run(job);
  const ClearanceReport many = check(sliced, "cartesian_gantry");
  const ThreadLimit limit(1);
  const ClearanceReport one = check(sliced, "cartesian_gantry");
  EXPECT_EQ(one.colliding, many.colliding);
  ASSERT_EQ(one.first_of_layers.size(), many.first_of_layers.size());
  ASSERT_GT(one.first_of_layers.size(), 1U);
  for (std::size_t i = 0; i < one.first_of_layers.size(); ++i) {
    const Collision& a = one.first_of_layers[i];
    const Collision& b = many.first_of_layers[i];
    EXPECT_EQ(a.at.layer, b.at.layer);
    EXPECT_EQ(a.at.path, b.at.path);
    EXPECT_EQ(a.at.waypoint, b.at.waypoint);
    EXPECT_EQ(a.tip, b.tip);
    EXPECT_EQ(a.link, b.link);
    EXPECT_EQ(a.place, b.place);
  }
}

}  // namespace
}  // namespace lamina
