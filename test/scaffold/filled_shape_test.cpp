// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/scaffold/scaffold.hpp"
#include "scaffold/convex_clip.hpp"
#include "scaffold/gyroid.hpp"

namespace lamina {
namespace {

double volumeOf(const Toolpath& toolpath) { return totals(toolpath).deposited_mm3; }

TEST(FilledShapeTest, CylindersLayWhatTheirPublishedProgramsLay) {
  // [Vega2023, table 9]: theoretical volumes of programs of 50 and 40 % rectilinear fill.
  ScaffoldSettings settings = scaffoldDefaults("cylinder");
  const Toolpath half = makeScaffold("cylinder", settings);
  validate(half);
  EXPECT_NEAR(volumeOf(half), 278.80, 0.06 * 278.80);
  settings.density = 0.4;
  EXPECT_NEAR(volumeOf(makeScaffold("cylinder", settings)), 231.16, 0.06 * 231.16);
}

TEST(FilledShapeTest, LayersMakeUpThePublishedHeights) {
  const auto heightOf = [](const std::string& name, double layer_height) {
    ScaffoldSettings settings = scaffoldDefaults(name);
    settings.layer_height_mm = layer_height;
    const Toolpath toolpath = makeScaffold(name, settings);
    return std::make_pair(toolpath.layers.size(), toolpath.layers.back().z_mm);
  };
  EXPECT_EQ(heightOf("cylinder", 0.3).first, 23U);
  EXPECT_NEAR(heightOf("cylinder", 0.3).second, 6.95, 1e-9);
  EXPECT_EQ(heightOf("bending_specimen", 0.3).first, 7U);
  EXPECT_NEAR(heightOf("bending_specimen", 0.3).second, 2.1, 1e-9);
  EXPECT_EQ(heightOf("bending_specimen", 0.15).first, 13U);
  EXPECT_NEAR(heightOf("bending_specimen", 0.15).second, 1.95, 1e-9);
  EXPECT_NEAR(heightOf("cube", 0.3).second, 9.0, 1e-9);
}

TEST(FilledShapeTest, FullSpecimensWeighWhatStadiumsSideBySideWeigh) {
  constexpr double kPla = 1.24e-3;  // g/mm³
  for (const auto& [layer, height] : {std::make_pair(0.3, 2.1), std::make_pair(0.15, 1.95)}) {
    ScaffoldSettings settings = scaffoldDefaults("bending_specimen");
    settings.layer_height_mm = layer;
    settings.density = 1.0;
    settings.perimeters = 3;
    const double packing = crossSection({0.48, layer}) / (0.48 * layer);
    const double expected = packing * 40.0 * 5.0 * height * kPla;
    EXPECT_NEAR(kPla * volumeOf(makeScaffold("bending_specimen", settings)), expected, 0.03 * expected);
  }
}

TEST(FilledShapeTest, DensityIsThePartOfTheShapeThatIsFilled) {
  for (const ScaffoldFill fill : {ScaffoldFill::Rectilinear, ScaffoldFill::Concentric, ScaffoldFill::Gyroid})
    for (const double density : {0.2, 0.5}) {
      ScaffoldSettings settings = scaffoldDefaults("box");
      settings.length_mm = settings.breadth_mm = 40.0;
      settings.height_mm = 12.0;
      settings.fill = fill;
      settings.density = density;
      const Toolpath toolpath = makeScaffold("box", settings);
      validate(toolpath);
      // Lines are joined at the border, which lays a little more; rings begin and end with a whole one.
      EXPECT_NEAR(volumeOf(toolpath) / (40.0 * 40.0 * 12.0), density, 0.1 * density) << int(fill);
    }
}

TEST(FilledShapeTest, StaysInsideItsOutline) {
  for (const ScaffoldFill fill :
       {ScaffoldFill::Rectilinear, ScaffoldFill::Concentric, ScaffoldFill::Gyroid}) {
    ScaffoldSettings settings = scaffoldDefaults("cylinder");
    settings.fill = fill;
    settings.perimeters = 1;
    const Toolpath toolpath = makeScaffold("cylinder", settings);
    const double pitch = planWidth({0.48, 0.3});
    ASSERT_FALSE(toolpath.layers.empty());
    for (const ToolpathLayer& layer : toolpath.layers)
      for (const Path& path : layer.paths) {
        if (path.role == PathRole::Travel) continue;
        for (const Point3& point : path.points)
          EXPECT_LE((point.head<2>() - Point2(5, 5)).norm(), 5.0 - 0.5 * pitch + 1e-4);
      }
  }
}

TEST(FilledShapeTest, RefusesAShapeWithoutRoom) {
  ScaffoldSettings settings = scaffoldDefaults("box");
  settings.length_mm = settings.breadth_mm = 0.3;
  EXPECT_THROW(makeScaffold("box", settings), InvalidConfig);
}

TEST(FilledShapeTest, EveryKindHasAMeaningAndDefaultsThatWork) {
  for (const std::string& name : scaffoldNames()) {
    EXPECT_FALSE(scaffoldMeaning(name).empty());
    EXPECT_GT(volumeOf(makeScaffold(name, scaffoldDefaults(name))), 0.0);
  }
}

TEST(GyroidTest, CurvesLieOnTheSurface) {
  const Polygon square{{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
  for (int cut = 0; cut < 24; ++cut) {
    const GyroidSlice slice{4.0, 0.17 + cut * 4.0 / 24.0, 0.0};
    const auto lines = gyroidLines(slice, square);
    EXPECT_FALSE(lines.empty());
    const double k = 2.0 * M_PI / 4.0;
    const double z = k * slice.z_mm;
    for (const Polyline& line : lines)
      for (const Point2& point : line) {
        const double x = k * point.x();
        const double y = k * point.y();
        const double value =
            std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
        EXPECT_NEAR(value, 0.0, 2e-2) << "cut " << cut;
      }
  }
}

TEST(ConvexClipTest, KeepsThePiecesInside) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto pieces = clippedToConvex({{-1, 1}, {2, 1}, {3, 5}, {3, 3}, {3.5, 3}}, square);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].front().isApprox(Point2(0, 1)));
  EXPECT_TRUE(pieces[0].back().isApprox(Point2(2.75, 4)));
  EXPECT_TRUE(pieces[1].front().isApprox(Point2(3, 4)));
  EXPECT_EQ(pieces[1].size(), 3U);
  EXPECT_TRUE(clippedToConvex({{5, 5}, {6, 6}}, square).empty());
}

}  // namespace
}  // namespace lamina
