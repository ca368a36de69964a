// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/plain_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

constexpr double kDensity = 0.25;

SlicedPart slicedBlock(SliceJob job) {
  const test::ScratchFolder folder;
  job.part = folder.file("block.stl");
  writeStl(job.part, makePart("box", {{"x_mm", "14"}, {"y_mm", "11"}, {"z_mm", "6"}}));
  NoProgress nobody;
  return runSliceJob(job, nobody);
}

/// A block in layers at that angle, for a head that points straight down.
Toolpath blockOfGyroid(double angle_deg) {
  SliceJob job;
  job.settings.slicing.plane = {angle_deg, 30.0, ToolAxis::Down};
  job.settings.planning.infill.strategy = "gyroid";
  job.settings.planning.infill.density = kDensity;
  job.settings.planning.infill.angle_deg = 0.0;
  job.settings.planning.infill.links.link = LineLink::None;
  return slicedBlock(job).toolpath;
}

double gyroidAt(const Point3& point) {
  const double pitch = 0.4 - (1.0 - M_PI / 4.0) * 0.2;
  const Point3 phase = 2.0 * M_PI * kDensity / (2.4586 * pitch) * point;
  return std::sin(phase.x()) * std::cos(phase.y()) + std::sin(phase.y()) * std::cos(phase.z()) +
         std::sin(phase.z()) * std::cos(phase.x());
}

/// Beads lie on one surface, whatever the layers: within the chord error and what smoothing leaves out.
TEST(GyroidJob, LaysOneSurfaceInThePartInLevelAndInclinedLayers) {
  for (const double angle_deg : {0.0, 30.0, 45.0}) {
    std::size_t points = 0;
    for (const ToolpathLayer& layer : blockOfGyroid(angle_deg).layers)
      for (const Path& path : layer.paths) {
        if (path.role != PathRole::Infill) continue;
        for (const Point3& point : path.points) {
          ++points;
          ASSERT_NEAR(gyroidAt(point), 0.0, 0.06) << angle_deg << " deg at " << point.transpose();
        }
      }
    EXPECT_GT(points, 1000U) << angle_deg;
  }
}

/// Squares of a pitch where beads of a grid cross, each deposited twice: p² in (2 s)², of p / s in all.
TEST(PatternJob, ReportsHowMuchLiesOnItselfWhereLinesCross) {
  SliceJob job = test::plainJob();
  job.settings.planning.infill.strategy = "grid";
  job.settings.planning.infill.density = 0.2;
  const std::vector<std::string> notes = slicedBlock(job).summary.notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes.front(), "lines of infill 'grid' cross: 5.0 % of its volume is deposited twice");
  for (const char* strategy : {"gyroid", "zigzag"}) {
    job.settings.planning.infill.strategy = strategy;
    EXPECT_TRUE(slicedBlock(job).summary.notes.empty()) << strategy;
  }
}

/// A lattice of squares leaves a part open beside borders that do not lie along it.
TEST(PatternJob, SaysWhatCellsOfASolidInfillLeaveOpen) {
  SliceJob job = test::plainJob();
  job.settings.planning.infill.strategy = "hilbert_quadtree";
  job.settings.planning.infill.density = 1.0;
  const test::ScratchFolder folder;
  job.part = folder.file("disc.stl");
  writeStl(job.part, makePart("cylinder", {{"radius_mm", "10"}, {"height_mm", "1"}}));
  NoProgress nobody;
  const std::vector<std::string> notes = runSliceJob(job, nobody).summary.notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes.front().rfind("cells of solid infill 'hilbert_quadtree' do not fit everywhere: ", 0), 0U)
      << notes.front();
  EXPECT_NE(notes.front().find("more than 0.5 % in 5;"), std::string::npos) << notes.front();
  job.settings.planning.infill.density = 0.5;
  EXPECT_TRUE(runSliceJob(job, nobody).summary.notes.empty());
}

}  // namespace
}  // namespace lamina
