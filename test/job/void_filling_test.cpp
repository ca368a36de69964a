// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/void_filling.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/program/toolpath_from_gcode.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class VoidFillingTest : public ::testing::Test {
 protected:
  /// A tube filled by a Hilbert curve, which leaves voids along its round walls.
  SlicedPart slice(const std::string& output, VoidRefill refill) {
    SliceJob job;
    job.part = "tube";
    job.output = output;
    job.settings = settings_;
    job.settings.planning.voids.refill = refill;
    NoProgress progress;
    return runSliceJob(job, progress);
  }

  VoidFillingReport fill() {
    NoProgress progress;
    return runVoidFillingJob(job_, progress);
  }

  VoidFillingTest() {
    settings_.planning.infill.strategy = "hilbert";
    settings_.planning.infill.density = 1.0;
    settings_.slicing.layer_height_mm = 0.5;
    settings_.slicing.first_layer_height_mm = 0.5;
    settings_.planning.bead.width_mm = 0.8;
    job_.program = folder_.file("tube.gcode");
    job_.output = folder_.file("filled.gcode");
    job_.map.part = "tube";
    job_.map.settings = settings_;
  }

  test::ScratchFolder folder_;
  JobSettings settings_;
  VoidFillingJob job_;
};

TEST_F(VoidFillingTest, OfAWrittenProgramGivesWhatSlicingWithRefillingGives) {
  slice(job_.program, VoidRefill::None);
  const VoidFillingReport filled = fill();
  const SliceSummary refilled = slice(folder_.file("refilled.gcode"), VoidRefill::Beads).summary;
  ASSERT_GT(filled.runs, 0U);
  EXPECT_EQ(refilled.refilling.runs, filled.runs);
  // One cuts and simplifies the part itself, the other has the coordinates of a program.
  EXPECT_NEAR(refilled.refilling.deposited_mm3, filled.deposited_mm3, 0.02 * filled.deposited_mm3);
}

TEST_F(VoidFillingTest, CoversMoreAndTellsWhatTheNewProgramDeposits) {
  slice(job_.program, VoidRefill::None);
  const VoidFillingReport filled = fill();
  EXPECT_LT(filled.after.uncovered.mean_percent, filled.before.uncovered.mean_percent);
  NoProgress progress;
  const Toolpath result = toolpathFromGcodeFile(job_.output, settings_.program);
  const VoidTotals read = totals(runVoidJob(result, job_.map, progress).layers);
  EXPECT_NEAR(read.uncovered.mean_percent, filled.after.uncovered.mean_percent, 1e-9);
  EXPECT_NEAR(read.runs_per_layer_mean, filled.after.runs_per_layer_mean, 1e-9);
}

TEST_F(VoidFillingTest, RefusesToWriteOverItsProgram) {
  slice(job_.program, VoidRefill::None);
  job_.output = job_.program;
  EXPECT_THROW(fill(), InvalidInput);
}

}  // namespace
}  // namespace lamina
