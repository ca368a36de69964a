// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/job/voids/void_job.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"

namespace lamina {
namespace {

constexpr double kHeightRounding = 0.5e-5 * (1 + 1e-6);          // mm: half the last decimal
constexpr double kVolumeRounding = 2e-5 * M_PI * 0.875 * 0.875;  // mm³: both ends of the sum of E

Toolpath boxAsVase(int base_layers) {
  SliceJob job;
  job.part = "box";
  job.settings.planning.infill.strategy = "vase";
  job.settings.planning.skirt.count = 0;
  job.settings.planning.fill.vase.base_layers = base_layers;
  NoProgress progress;
  return runSliceJob(job, progress).toolpath;
}

Toolpath readBack(const Toolpath& toolpath) {
  std::string text;
  writeGcode(toolpath, Eigen::Isometry3d::Identity(), {}, [&](std::string_view piece) { text += piece; });
  return toolpathFromGcode(text, {}, toolpath.part_name);
}

double volumeOf(const ToolpathLayer& layer) {
  double sum = 0.0;
  for (const Path& path : layer.paths) sum += depositedVolume(path);
  return sum;
}

void expectSameHeights(const Path& read, const Path& original) {
  ASSERT_EQ(read.points.size(), original.points.size());
  for (std::size_t m = 0; original.role != PathRole::Travel && m < original.motionCount(); ++m) {
    const std::size_t end = original.motionEnd(m);
    EXPECT_NEAR(read.bead.at(end).height_mm, original.bead.at(end).height_mm, kHeightRounding);
  }
}

class VaseJob : public testing::TestWithParam<int> {};

TEST_P(VaseJob, KeepsVolumesAndHeightsInItsProgram) {
  const Toolpath original = boxAsVase(GetParam());
  const Toolpath read = readBack(original);
  ASSERT_EQ(read.layers.size(), original.layers.size());
  for (std::size_t l = 0; l < read.layers.size(); ++l) {
    SCOPED_TRACE("layer " + std::to_string(l));
    EXPECT_NEAR(read.layers[l].height_mm, original.layers[l].height_mm, kHeightRounding);
    EXPECT_NEAR(volumeOf(read.layers[l]), volumeOf(original.layers[l]), kVolumeRounding);
    ASSERT_EQ(read.layers[l].paths.size(), original.layers[l].paths.size());
    for (std::size_t p = 0; p < read.layers[l].paths.size(); ++p)
      expectSameHeights(read.layers[l].paths[p], original.layers[l].paths[p]);
  }
}

INSTANTIATE_TEST_SUITE_P(BaseLayers, VaseJob, testing::Values(0, 3));

TEST(VaseVoids, OfItsProgramAreWhatIsHollow) {
  const Toolpath read = readBack(boxAsVase(3));
  VoidJob job;
  job.part = "box";
  job.offset = Point2::Zero();
  NoProgress progress;
  const VoidReport report = runVoidJob(read, job, progress);
  ASSERT_EQ(report.layers.size(), 100U);
  const Bead bead = boxAsVase(0).layers[50].paths.front().bead.at(1);
  // The box is 20 mm wide; its wall reaches half a stadium to either side of a line half a plan width inside.
  const double inside = 20.0 - planWidth(bead) - bead.width_mm;
  for (std::size_t l = 0; l < report.layers.size(); ++l) {
    SCOPED_TRACE("layer " + std::to_string(l));
    const LayerVoids& layer = report.layers[l];
    const double open = l < 3 ? 0.0 : inside * inside;
    EXPECT_NEAR(layer.uncovered_mm2, open, 0.01 * layer.area_mm2);
    // The last turn lies on the one below it, from all of its height down to none.
    if (l + 1 < report.layers.size()) {
      EXPECT_LT(layer.overfill_mm2, 0.01 * layer.area_mm2);
    }
  }
}

}  // namespace
}  // namespace lamina
