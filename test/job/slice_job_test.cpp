// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/slice_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/toolpath/scan_height.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// Remembers the stages; cancels as soon as one begins.
class Watch final : public Progress {
 public:
  explicit Watch(std::string cancelled_stage = "") : cancelled_stage_(std::move(cancelled_stage)) {}
  void report(const std::string& stage, double) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    stages_.insert(stage);
  }
  bool isCancelled() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stages_.count(cancelled_stage_) > 0;
  }
  std::set<std::string> stages() const { return stages_; }

 private:
  mutable std::mutex mutex_;
  std::string cancelled_stage_;
  std::set<std::string> stages_;
};

class SliceJobTest : public ::testing::Test {
 protected:
  SliceJobTest() {
    job_.part = folder_.file("box.stl");
    job_.output = folder_.file("box.csv");
    job_.settings.planning.skirt.count = 0;
    writeStl(job_.part, test::boxBetween({10, 20, 5}, {30, 50, 6}));
  }

  SlicedPart run() {
    Watch progress;
    return runSliceJob(job_, progress);
  }

  bool hasOutput() const { return std::filesystem::exists(job_.output); }

  test::ScratchFolder folder_;
  SliceJob job_;
};

TEST_F(SliceJobTest, SummarisesABoxExactly) {
  const SliceSummary summary = run().summary;
  EXPECT_EQ(summary.triangles, 12U);
  EXPECT_EQ(summary.layers, 5U);
  EXPECT_EQ(summary.contours, 5U);
  EXPECT_EQ(summary.open_contours, 0U);
  EXPECT_NEAR(summary.mesh_volume_mm3, 600.0, 1e-9);
  EXPECT_NEAR(summary.sliced_volume_mm3, 600.0, 1e-9);
  EXPECT_TRUE(summary.repairs.empty());
  EXPECT_GT(summary.estimated_time_s, 0.0);
  EXPECT_GT(summary.peak_memory_mb, 0.0);
  EXPECT_GE(summary.wall_s, summary.read_s + summary.slice_s + summary.plan_s);
}

TEST_F(SliceJobTest, NamesWhatIsFedBeyondTheBeads) {
  job_.settings.program.flow = 1.5;
  const SliceSummary summary = run().summary;
  char fed[64];
  std::snprintf(fed, sizeof fed, "feeds %.2f cm3 for the %.2f cm3", 1.5e-3 * summary.deposited_mm3,
                1e-3 * summary.deposited_mm3);
  ASSERT_EQ(summary.notes.size(), 1U);
  EXPECT_NE(summary.notes.front().find(fed), std::string::npos) << summary.notes.front();
}

TEST_F(SliceJobTest, KeepsThePartsCoordinatesAndPlacesItOnTheBed) {
  const SlicedPart sliced = run();
  const Box3 box = depositionBox(sliced.toolpath);
  EXPECT_NEAR(box.centre().x(), 20.0, 1e-3);
  EXPECT_NEAR(box.low.x(), 10.2, 1e-3);
  EXPECT_NEAR(box.low.z(), 5.2, 1e-9);
  // Middle of the bed of 220 mm.
  EXPECT_TRUE((sliced.bed_from_part * Point3(20, 35, 5)).isApprox(Point3(110, 110, 0)));
}

TEST_F(SliceJobTest, WritesTheToolpathItReturns) {
  const SlicedPart sliced = run();
  const Toolpath written = readCsv(readFile(job_.output), "box");
  const ToolpathTotals a = totals(sliced.toolpath);
  const ToolpathTotals b = totals(written);
  EXPECT_EQ(a.waypoints, b.waypoints);
  EXPECT_DOUBLE_EQ(a.deposition_mm, b.deposition_mm);
  EXPECT_DOUBLE_EQ(a.deposited_mm3, sliced.summary.deposited_mm3);
}

// grbl goes by G28 straight to a stored place, and has no heaters.
TEST_F(SliceJobTest, BeginsAProgramForGrblWithALiftAlone) {
  job_.output = folder_.file("box.gcode");
  job_.settings.program.dialect = "grbl";
  job_.settings.program.nozzle_temperature_c = job_.settings.program.bed_temperature_c = 0.0;
  run();
  const std::string text = readFile(job_.output);
  for (const char* word : {"G28", "M84", "M104", "M140"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  EXPECT_NE(text.find("\nG21\nG90\nG0 Z5\n"), std::string::npos) << text.substr(0, 400);
  EXPECT_NE(text.find("\nG91\nG0 Z5\nG90\n"), std::string::npos);
}

TEST_F(SliceJobTest, WritesTheSameBytesWithAnyNumberOfThreads) {
  job_.part = "sphere";
  run();
  const std::string expected = readFile(job_.output);
  const ThreadLimit one(1);
  run();
  EXPECT_EQ(readFile(job_.output), expected);
}

TEST_F(SliceJobTest, LeadsTheWireAsFastAsTheFlowIsLimitedTo) {
  job_.settings.runs.levels.values = "wire_speed_mm_s=from_bead";
  job_.settings.flow.greatest_mm3_s = 1.0;
  job_.settings.cooling.least_layer_time_s = 0.0;
  const SlicedPart sliced = run();
  double fastest_mm_s = 0.0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (const ProcessValue& value : path.values) {
        if (value.name != "wire_speed_mm_s") continue;
        for (const double speed_mm_s : value.value.values())
          fastest_mm_s = std::max(fastest_mm_s, speed_mm_s);
      }
  EXPECT_NEAR(fastest_mm_s, 0.88419, 1e-5);  // 1 mm3/s by 1.13097 mm2 of wire
}

TEST_F(SliceJobTest, TakesAParametricPartByItsName) {
  job_.part = "box";
  const SlicedPart sliced = run();
  EXPECT_EQ(sliced.toolpath.part_name, "box");
  EXPECT_NEAR(sliced.summary.sliced_volume_mm3 / sliced.summary.mesh_volume_mm3, 1.0, 1e-9);
}

TEST_F(SliceJobTest, ScalesThePart) {
  job_.settings.input.units.scale = 2.0;
  EXPECT_NEAR(run().summary.mesh_volume_mm3, 4800.0, 1e-6);
  job_.part = "box";
  const double doubled = run().summary.mesh_volume_mm3;
  job_.settings.input.units.scale = 1.0;
  EXPECT_NEAR(doubled / run().summary.mesh_volume_mm3, 8.0, 1e-9);
}

TEST_F(SliceJobTest, ReportsItsStages) {
  Watch watch;
  runSliceJob(job_, watch);
  EXPECT_EQ(watch.stages(), (std::set<std::string>{"read", "slice", "skins", "plan", "cool", "write"}));
}

/// Remembers what is reported of one stage.
class StageWatch final : public Progress {
 public:
  explicit StageWatch(std::string stage) : stage_(std::move(stage)) {}
  void report(const std::string& stage, double fraction) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stage == stage_) fractions.push_back(fraction);
  }
  bool isCancelled() const override { return false; }

  std::vector<double> fractions;

 private:
  std::mutex mutex_;
  std::string stage_;
};

TEST_F(SliceJobTest, ReportsHowFarASingleLayerIsFlattened) {
  // Tops of 100 and 300 mm2, the pieces of one layer.
  writeStl(job_.part,
           joined(test::boxBetween({0, 0, 0}, {10, 10, 5}), test::boxBetween({20, 0, 0}, {30, 30, 5})));
  job_.settings.slicing.mode = "conformal";
  job_.settings.conformal.thickness_mm = job_.settings.slicing.layer_height_mm;
  StageWatch watch("flatten");
  runSliceJob(job_, watch);
  ASSERT_EQ(watch.fractions.size(), 2U);
  EXPECT_NEAR(watch.fractions.front(), 0.25, 1e-9);
  EXPECT_NEAR(watch.fractions.back(), 1.0, 1e-9);
}

TEST_F(SliceJobTest, WritesNothingWhenCancelled) {
  for (const char* stage : {"read", "slice", "plan", "write"}) {
    Watch watch(stage);
    EXPECT_THROW(runSliceJob(job_, watch), Cancelled) << stage;
    EXPECT_FALSE(hasOutput()) << stage;
  }
}

TEST_F(SliceJobTest, TheSummarysTravelIsThatOfTheProgramWithTheWaysToWaits) {
  job_.output = folder_.file("box.gcode");
  job_.settings.cooling.by = CoolingBy::Dwell;
  const auto travelReadBack = [this] {
    return totals(readProgram(job_.output, job_.settings.program, job_.settings.machine)).travel_mm;
  };
  job_.settings.cooling.least_layer_time_s = 0.0;
  const double without_mm = run().summary.travel_mm;
  EXPECT_NEAR(without_mm, travelReadBack(), 0.01);
  job_.settings.cooling.least_layer_time_s = 600.0;
  const SlicedPart waiting = run();
  EXPECT_NEAR(waiting.summary.travel_mm, travelReadBack(), 0.01);
  // Four of five layers wait at least 5 mm beside the part.
  ASSERT_EQ(waiting.summary.layers, 5u) << "of 0.2 mm";
  EXPECT_GT(waiting.summary.travel_mm, without_mm + 4 * 5.0);
}

TEST_F(SliceJobTest, TheSummarysTravelIsThatOfTheProgramWithPauses) {
  job_.output = folder_.file("box.gcode");
  job_.settings.cooling.least_layer_time_s = 0.0;
  const double without_mm = run().summary.travel_mm;
  job_.settings.pauses.at_layers = {2};
  const double with_mm = run().summary.travel_mm;
  EXPECT_GT(with_mm, without_mm + 5.0);
  EXPECT_NEAR(totals(readProgram(job_.output, job_.settings.program, job_.settings.machine)).travel_mm,
              with_mm, 0.01);
}

TEST_F(SliceJobTest, RefusesAPartWithoutALayer) {
  job_.settings.slicing.first_layer_height_mm = 2.5;
  EXPECT_THROW(run(), InvalidInput);
}

TEST_F(SliceJobTest, RefusesAPartLargerThanTheMachine) {
  job_.settings.input.units.scale = 20.0;
  EXPECT_THROW(run(), Unreachable);
  EXPECT_FALSE(hasOutput());
}

TEST_F(SliceJobTest, NamesTheUnitOfAPartThatIsVerySmall) {
  writeStl(job_.part, test::boxBetween({0, 0, 0}, {2, 2, 1}));
  const SliceSummary small = run().summary;
  ASSERT_FALSE(small.notes.empty());
  const auto note = std::find_if(small.notes.begin(), small.notes.end(), [](const std::string& each) {
    return each.find("input.unit") != std::string::npos;
  });
  ASSERT_NE(note, small.notes.end());
  EXPECT_NE(note->find("2 x 2 x 1 mm"), std::string::npos) << *note;
}

TEST_F(SliceJobTest, RefusesAPartFarFromTheOrigin) {
  writeStl(job_.part, test::boxBetween({20000, 0, 0}, {20010, 10, 1}));
  EXPECT_THROW(run(), InvalidMesh);
  EXPECT_FALSE(hasOutput());
}

TEST_F(SliceJobTest, RefusesAPartBesideTheBed) {
  job_.settings.placement = Placement::AsIs;
  writeStl(job_.part, test::boxBetween({-50, 0, 0}, {-40, 10, 1}));
  EXPECT_THROW(run(), Unreachable);
  EXPECT_FALSE(hasOutput());
}

/// 5 mm beside a part that stands 1 mm from the edge of the bed there is none.
TEST_F(SliceJobTest, PausesWithinTheMachinesReach) {
  job_.settings.placement = Placement::AsIs;
  job_.output = folder_.file("box.gcode");
  job_.settings.pauses.at_layers = {2};
  writeStl(job_.part, test::boxBetween({1, 50, 0}, {21, 80, 1}));
  const SlicedPart sliced = run();
  double least_x_mm = 1e9;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points) least_x_mm = std::min(least_x_mm, point.x());
  EXPECT_GE(least_x_mm, 0.0);
  EXPECT_TRUE(
      std::any_of(sliced.summary.notes.begin(), sliced.summary.notes.end(), [](const std::string& note) {
        return note.find("cooling.park is out of the machine's reach") != std::string::npos;
      }));
}

TEST_F(SliceJobTest, RefusesAPartThatIsNarrowerThanAnyBead) {
  // A fin of 0.1 mm for a bead of 0.4 mm, with a skirt that would be all that is printed.
  writeStl(job_.part, test::boxBetween({10, 20, 5}, {30, 20.1, 6}));
  job_.settings.planning.skirt.count = 1;
  EXPECT_THROW(run(), InvalidInput);
  EXPECT_FALSE(hasOutput());
}

TEST_F(SliceJobTest, PrintsAFinThatIsNarrowerThanABead) {
  writeStl(job_.part, test::boxBetween({10, 20, 5}, {30, 20.3, 6}));
  const SlicedPart sliced = run();
  // The bead ends half its width from both ends, and fills less than its width.
  const double fills = 0.3 - (1.0 - M_PI / 4.0) * 0.2;
  EXPECT_NEAR(sliced.summary.deposited_mm3, (20 - 0.3) * fills * 1.0, 0.02);
  EXPECT_EQ(sliced.summary.unprinted_mm3, 0.0);
}

TEST_F(SliceJobTest, ReportsWhatAFillLeavesOutWhole) {
  // A drop of 1 mm fits the one box, and not the other: 0.5 x 20 x 1 mm.
  const Mesh wide = test::boxBetween({0, 0, 0}, {10, 10, 1});
  writeStl(job_.part, joined(wide, test::boxBetween({15, 0, 0}, {15.5, 20, 1})));
  job_.settings.planning.infill.strategy = "drops_raster";
  job_.settings.planning.infill.density = 1.0;
  for (double* size :
       {&job_.settings.planning.fill.drops.diameter_mm, &job_.settings.planning.fill.drops.pitch_mm,
        &job_.settings.planning.fill.drops.line_spacing_mm})
    *size = 1.0;
  EXPECT_NEAR(run().summary.unprinted_mm3, 0.5 * 20.0 * 1.0, 1e-6);
}

TEST_F(SliceJobTest, CountsEmptyLayersBelowOthers) {
  // Nothing fits the neck, 0.05 mm thick, from 1 to 2 mm: 5 layers of 0.2 mm.
  const Mesh foot = test::boxBetween({0, 0, 0}, {10, 10, 1});
  const Mesh neck = test::boxBetween({5, 5, 1}, {5.05, 5.05, 2});
  writeStl(job_.part, joined(joined(foot, neck), test::boxBetween({0, 0, 2}, {10, 10, 3})));
  const SlicedPart sliced = run();
  EXPECT_EQ(sliced.summary.empty_layers, 5U);
  EXPECT_NEAR(sliced.summary.unprinted_mm3, 0.05 * 0.05 * 1.0, 1e-6);
}

double infillVolume(const Toolpath& toolpath) {
  double sum_mm3 = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Infill) sum_mm3 += depositedVolume(path);
  return sum_mm3;
}

/// Lines of unequal layers are as far apart in all of them.
TEST_F(SliceJobTest, FillsByItsDensityInLayersOfUnequalHeightWhateverTheBeads) {
  writeStl(job_.part, test::boxBetween({0, 0, 0}, {60, 60, 3}));
  job_.settings.slicing.heights = LayerHeights::Adaptive;
  job_.settings.planning.walls.count = 1;
  job_.settings.planning.skins.top_layers = job_.settings.planning.skins.bottom_layers = 0;
  job_.settings.planning.infill.density = 0.2;
  // Within one wall of 0.4 mm, and joined along the border by some of the same again.
  const double inside_mm3 = 59.3 * 59.3 * 3.0;
  for (const double width_mm : {0.4, 0.8}) {
    job_.settings.planning.infill.bead_width_mm = width_mm;
    EXPECT_NEAR(infillVolume(run().toolpath) / inside_mm3, 0.2, 0.03) << width_mm;
  }
}

TEST_F(SliceJobTest, RefusesAMachineThatIsNotThere) {
  job_.settings.machine.name = "warp_drive";
  EXPECT_THROW(run(), InvalidConfig);
}

TEST_F(SliceJobTest, RefusesBadSettingsBeforeReading) {
  job_.settings.planning.bead.width_mm = 0.0;
  Watch watch;
  EXPECT_THROW(runSliceJob(job_, watch), InvalidConfig);
  EXPECT_TRUE(watch.stages().empty());
}

TEST_F(SliceJobTest, RefusesAnOutputWithoutWriterBeforeReading) {
  job_.output = folder_.file("box.stl");
  const std::string mesh = readFile(job_.part);
  Watch watch;
  EXPECT_THROW(runSliceJob(job_, watch), InvalidInput);
  EXPECT_TRUE(watch.stages().empty());
  EXPECT_EQ(readFile(job_.part), mesh);
}

TEST_F(SliceJobTest, RefusesAPartThatIsMissingOrNoMesh) {
  std::ofstream(folder_.file("text.stl")) << "hello";
  job_.part = folder_.file("text.stl");
  EXPECT_THROW(run(), InvalidMesh);
  job_.part = folder_.file("missing.stl");
  EXPECT_THROW(run(), FileError);
  EXPECT_FALSE(hasOutput());
}

TEST_F(SliceJobTest, ScansTheLayersItIsAskedTo) {
  job_.settings.scan.every_layers = 2;
  const SlicedPart sliced = run();
  std::size_t scanned = 0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers) scanned += isScanned(layer, 1.0) ? 1 : 0;
  EXPECT_EQ(scanned, (sliced.toolpath.layers.size() + 1) / 2);
  EXPECT_NO_THROW(validate(sliced.toolpath));
}

}  // namespace
}  // namespace lamina
