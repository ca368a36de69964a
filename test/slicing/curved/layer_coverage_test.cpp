// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/layer_coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/parts/parts.hpp"
#include "support/curved_parts.hpp"

namespace lamina {
namespace {

constexpr double kSide = 10.0;

Mesh cube() { return makePart("box", {{"x_mm", "10"}, {"y_mm", "10"}, {"z_mm", "10"}}); }

/// A layer of the cube, 1 mm high, whose middle is at a height, from x = 0 to a width.
LayerSurface sheet(double z, double width = kSide) {
  const Point3 low = boundingBox(cube()).low;
  LayerSurface layer;
  layer.middle =
      test::gridSurface(5, [&](double u, double v) { return Point3(low + Point3(width * u, kSide * v, z)); });
  for (const Point3& vertex : layer.middle.vertices) {
    layer.tip.emplace_back(vertex + 0.5 * Point3::UnitZ());
    layer.normal.emplace_back(Point3::UnitZ());
    layer.height_mm.push_back(1.0);
  }
  return layer;
}

std::vector<LayerSurface> fullStack() {
  std::vector<LayerSurface> sheets;
  for (double z = 0.5; z < kSide; ++z) sheets.push_back(sheet(z));
  return sheets;
}

double share(const std::vector<LayerSurface>& sheets, std::uint32_t times) {
  const PartSamples samples(cube(), 4000);
  NoProgress progress;
  const auto counts = layerCounts(samples, {sheets, {}, {}}, progress);
  return static_cast<double>(std::count(counts.begin(), counts.end(), times)) /
         static_cast<double>(counts.size());
}

TEST(PartSamples, LieInsideAndAsManyAsAskedFor) {
  const Mesh sphere = makePart("sphere", {{"radius_mm", "7"}});
  const PartSamples samples(sphere, 4000);
  EXPECT_NEAR(static_cast<double>(samples.points().size()), 4000.0, 200.0);
  const Point3 centre = boundingBox(sphere).centre();
  std::size_t above = 0;
  for (const Point3& point : samples.points()) {
    ASSERT_LE((point - centre).norm(), 7.0);
    if (point.z() > centre.z()) ++above;
  }
  EXPECT_NEAR(static_cast<double>(above), 2000.0, 100.0);
}

TEST(LayerCoverage, OfAFullStackIsOneEverywhere) { EXPECT_EQ(share(fullStack(), 1), 1.0); }

TEST(LayerCoverage, AHoleAndAnOverlapOfTheSameVolumeDoNotCancel) {
  std::vector<LayerSurface> sheets = fullStack();
  sheets[7] = sheets[2];
  EXPECT_NEAR(share(sheets, 0), 0.1, 0.01);
  EXPECT_NEAR(share(sheets, 2), 0.1, 0.01);
}

TEST(LayerCoverage, BesideTheRimOfALayerNothingIsCovered) {
  std::vector<LayerSurface> sheets = fullStack();
  sheets[4] = sheet(4.5, 0.3 * kSide);
  EXPECT_NEAR(share(sheets, 0), 0.07, 0.01);
}

TEST(LayerCoverage, ALevelLayerCoversItsSlabWithinItsContours) {
  const Mesh part = cube();
  const Point3 low = boundingBox(part).low;
  const Polygon half = {{low.x(), low.y()},
                        {low.x() + 5.0, low.y()},
                        {low.x() + 5.0, low.y() + kSide},
                        {low.x(), low.y() + kSide}};
  Layer layer;
  layer.bounds = {low.z() + 2.0, low.z() + 4.0};
  layer.section.contours = {half};
  const PartSamples samples(part, 4000);
  NoProgress progress;
  const auto counts = layerCounts(samples, {{}, {layer}, {}}, progress);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Point3 at = samples.points()[i] - low;
    ASSERT_EQ(counts[i], at.x() < 5.0 && at.z() > 2.0 && at.z() < 4.0 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace lamina
