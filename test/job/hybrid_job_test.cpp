// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "lamina/base/progress.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {
namespace {

/// Metal deposition: beads 1.5 mm wide in layers of 0.5 mm, rasters along x and y in turn.
SliceJob metalJob(const std::string& part, HybridLines lines) {
  SliceJob job;
  job.part = part;
  PlanSettings& planning = job.settings.planning;
  planning = PlanSettings{};
  planning.bead.width_mm = 1.5;
  planning.walls.count = 0;
  planning.skirt.count = 0;
  planning.infill.strategy = "hybrid";
  planning.infill.density = 1.0;
  planning.infill.angle_deg = 0.0;
  planning.fill.hybrid.lines = lines;
  job.settings.slicing.layer_height_mm = 0.5;
  job.settings.slicing.first_layer_height_mm = 0.5;
  return job;
}

SlicedPart sliced(const SliceJob& job) {
  NoProgress progress;
  return runSliceJob(job, progress);
}

bool isRaster(const Path& path) { return path.role == PathRole::Infill; }

/// Convex parts need no jumps between sections [Flores2018, section 6.1.2].
class ConvexPart : public testing::TestWithParam<std::tuple<std::string, HybridLines>> {};

TEST_P(ConvexPart, NeedsOneRepositionALayerAndOneBetweenLayers) {
  const auto& [part, lines] = GetParam();
  const SlicedPart result = sliced(metalJob(part, lines));
  const std::size_t layers = result.toolpath.layers.size();
  std::size_t filled = 0;
  for (const ToolpathLayer& layer : result.toolpath.layers)
    filled += std::any_of(layer.paths.begin(), layer.paths.end(), isRaster) ? 1 : 0;
  EXPECT_GE(filled + 4, layers) << "only the poles of the sphere are too narrow for a raster";
  EXPECT_EQ(result.summary.repositions.to_fill, filled);
  EXPECT_EQ(result.summary.repositions.in_layer, 0U);
  EXPECT_EQ(result.summary.repositions.to_layer, layers - 1);
}

INSTANTIATE_TEST_SUITE_P(Parts, ConvexPart,
                         testing::Combine(testing::Values("box", "cylinder", "sphere"),
                                          testing::Values(HybridLines::Fitted, HybridLines::Metal)),
                         [](const testing::TestParamInfo<ConvexPart::ParamType>& part) {
                           return std::get<0>(part.param) +
                                  (std::get<1>(part.param) == HybridLines::Fitted ? "Fitted" : "Metal");
                         });

/// [Flores2018, figure 48]
TEST(HybridJob, TurnsItsRasterBetweenLayersByARightAngle) {
  const SlicedPart result = sliced(metalJob("box", HybridLines::Metal));
  std::vector<Point3> along;
  for (const std::size_t layer : {0U, 1U}) {
    const auto& paths = result.toolpath.layers[layer].paths;
    const Path& raster = *std::find_if(paths.begin(), paths.end(), isRaster);
    Point3 longest = Point3::Zero();
    for (std::size_t i = 1; i < raster.points.size(); ++i)
      if ((raster.points[i] - raster.points[i - 1]).norm() > longest.norm())
        longest = raster.points[i] - raster.points[i - 1];
    along.emplace_back(longest.normalized());
  }
  EXPECT_NEAR(std::abs(along[0].x()), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(along[1].y()), 1.0, 1e-9);
}

}  // namespace
}  // namespace lamina
