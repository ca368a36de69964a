// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_filling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

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

TEST_F(VoidFillingTest, CoversMoreAndReportsWhatTheNewProgramDeposits) {
  slice(job_.program, VoidRefill::None);
  const VoidFillingReport filled = fill();
  EXPECT_LT(filled.after.uncovered.mean_percent, filled.before.uncovered.mean_percent);
  NoProgress progress;
  const Toolpath result = toolpathFromGcodeFile(job_.output, settings_.program);
  const VoidTotals read = totals(runVoidJob(result, job_.map, progress).layers);
  EXPECT_NEAR(read.uncovered.mean_percent, filled.after.uncovered.mean_percent, 1e-9);
  EXPECT_NEAR(read.runs_per_layer_mean, filled.after.runs_per_layer_mean, 1e-9);
}

TEST_F(VoidFillingTest, LeavesASparseInfillSparse) {
  job_.map.part = "box";
  for (const double density : {0.0, 0.2}) {
    SliceJob job;
    job.part = "box";
    job.output = job_.program;
    job.settings = settings_;
    job.settings.planning.infill.strategy = "zigzag";
    job.settings.planning.infill.density = density;
    job.settings.planning.walls.count = 2;
    NoProgress progress;
    const SliceSummary sliced = runSliceJob(job, progress).summary;
    const VoidFillingReport filled = fill();
    EXPECT_LT(filled.deposited_mm3, 0.002 * sliced.mesh_volume_mm3) << density;
    EXPECT_GT(filled.open_mm3, 0.1 * sliced.mesh_volume_mm3) << density;
  }
}

TEST_F(VoidFillingTest, RefusesAPartThatTheProgramDoesNotPrint) {
  slice(job_.program, VoidRefill::None);
  for (const char* part : {"box", "cone", "through_hole_plate", "flat_wall"}) {
    job_.map.part = part;
    EXPECT_THROW(fill(), InvalidInput) << part;
  }
  EXPECT_FALSE(std::filesystem::exists(job_.output));
}

TEST_F(VoidFillingTest, RefusesAPartThatIsMuchLarger) {
  slice(job_.program, VoidRefill::None);
  job_.map.part = folder_.file("large.stl");
  writeStl(job_.map.part, test::boxBetween({-30, -30, 0}, {30, 30, 10}));
  EXPECT_THROW(fill(), InvalidInput);
}

TEST_F(VoidFillingTest, RefusesAnOffsetThatIsWrongOrNotANumber) {
  slice(job_.program, VoidRefill::None);
  NoProgress progress;
  const Toolpath program = toolpathFromGcodeFile(job_.program, settings_.program);
  const Point2 right = placeContours(program, job_.map, progress).offset;
  for (const Point2& wrong : {Point2(5, 0), Point2(-300, 20), Point2(std::nan(""), 0)}) {
    job_.map.offset = right + wrong;
    EXPECT_THROW(fill(), InvalidInput) << wrong.transpose();
  }
  job_.map.offset = right;
  EXPECT_GT(fill().runs, 0U);
}

TEST_F(VoidFillingTest, RefusesAProgramThatEndsBeforeItsPart) {
  slice(job_.program, VoidRefill::None);
  const std::string whole = readFile(job_.program);
  const std::size_t cut = whole.find(";LAYER:3\n");
  ASSERT_NE(cut, std::string::npos);
  job_.program = folder_.file("cut.gcode");
  writeFile(job_.program, whole.substr(0, cut));
  try {
    fill();
    FAIL() << "nothing is thrown";
  } catch (const InvalidInput& error) {
    const std::size_t layers = toolpathFromGcode(whole, settings_.program, "tube").layers.size();
    EXPECT_NE(std::string(error.what()).find("lacks " + std::to_string(layers - 3) + " layers"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(VoidFillingTest, LaysTheFirstLayerNoFasterThanThePlannerDoes) {
  slice(job_.program, VoidRefill::None);
  fill();
  const Toolpath result = toolpathFromGcodeFile(job_.output, settings_.program);
  const FeedSettings& feed = settings_.planning.feed;
  ASSERT_LT(feed.first_layer_mm_s, feed.infill_mm_s);
  for (const std::size_t layer : {0, 1})
    for (const Path& path : result.layers[layer].paths) {
      if (path.role != PathRole::GapFill) continue;
      EXPECT_NEAR(path.feed_mm_s.at(1), layer == 0 ? feed.first_layer_mm_s : feed.infill_mm_s, 1e-3);
    }
}

TEST_F(VoidFillingTest, RefusesToWriteOverItsProgram) {
  slice(job_.program, VoidRefill::None);
  job_.output = job_.program;
  EXPECT_THROW(fill(), InvalidInput);
}

}  // namespace
}  // namespace lamina
