// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/scaffold/scaffold.hpp"

namespace lamina {
namespace {

ScaffoldSettings settingsOf() {
  ScaffoldSettings settings = scaffoldDefaults("sinusoidal");
  settings.cycle_segments = 20;
  return settings;
}

std::vector<Path> filaments(const ToolpathLayer& layer) {
  std::vector<Path> found;
  for (const Path& path : layer.paths)
    if (path.role != PathRole::Travel) found.push_back(path);
  return found;
}

/// The offset of a filament a quarter of a cycle along, from the middle between its ends' lines.
Point3 quarterOf(const Path& path, int cycle_segments) {
  return path.points[static_cast<std::size_t>(cycle_segments / 4)];
}

TEST(SinusoidalTest, FillsTheHeightWithLayersOfFilaments) {
  for (const double layer : {0.15, 0.3}) {
    ScaffoldSettings settings = settingsOf();
    settings.layer_height_mm = layer;
    const Toolpath toolpath = makeScaffold("sinusoidal", settings);
    validate(toolpath);
    EXPECT_EQ(toolpath.layers.size(), static_cast<std::size_t>(std::round(9.0 / layer)));
    EXPECT_NEAR(toolpath.layers.back().z_mm, 9.0, 1e-9);
    for (const ToolpathLayer& each : toolpath.layers) EXPECT_EQ(filaments(each).size(), 5U);
    const Box3 box = depositionBox(toolpath);
    EXPECT_NEAR(box.low.x(), 0.0, 1e-9);
    EXPECT_NEAR(box.high.y(), 9.0, 1e-9);
  }
}

TEST(SinusoidalTest, FollowsTheWaveOfItsPattern) {
  ScaffoldSettings settings = settingsOf();
  settings.wave = ScaffoldWave::Sine;
  const Path sine = filaments(makeScaffold("sinusoidal", settings).layers[0])[0];
  EXPECT_TRUE(sine.points.front().isApprox(Point3(0.0, 0.5, 0.3)));
  EXPECT_NEAR(quarterOf(sine, 20).x(), 9.0 / 20.0, 1e-12);
  EXPECT_NEAR(quarterOf(sine, 20).y(), 1.0, 1e-12);
  settings.wave = ScaffoldWave::Cosine;
  const Path cosine = filaments(makeScaffold("sinusoidal", settings).layers[0])[0];
  EXPECT_NEAR(cosine.points.front().y(), 1.0, 1e-12);
  EXPECT_NEAR(quarterOf(cosine, 20).y(), 0.5, 1e-12);
}

TEST(SinusoidalTest, TurnsByAQuarterFromLayerToLayer) {
  const Toolpath toolpath = makeScaffold("sinusoidal", settingsOf());
  for (std::size_t layer = 1; layer < 6; ++layer) {
    const Path below = filaments(toolpath.layers[layer - 1])[1];
    const Path above = filaments(toolpath.layers[layer])[1];
    for (std::size_t i = 0; i < below.points.size(); ++i) {
      const Point3& p = below.points[i];
      EXPECT_NEAR(above.points[i].x(), 9.0 - p.y(), 1e-9);
      EXPECT_NEAR(above.points[i].y(), p.x(), 1e-9);
    }
  }
}

TEST(SinusoidalTest, AlternatesSineAndCosineBeforeItTurns) {
  ScaffoldSettings settings = settingsOf();
  settings.wave = ScaffoldWave::SineCosine;
  const Toolpath toolpath = makeScaffold("sinusoidal", settings);
  const auto isAlongX = [&](std::size_t layer) {
    const Path path = filaments(toolpath.layers[layer])[0];
    return std::abs(path.points.back().x() - path.points.front().x()) > 8.0;
  };
  EXPECT_TRUE(isAlongX(0) && isAlongX(1) && !isAlongX(2) && !isAlongX(3) && isAlongX(4));
  // A quarter of a cycle on, a sine of amplitude 0.5 about 0.5 is at 1, and a cosine at 0.5.
  const auto quarter = [](const Toolpath& of, std::size_t layer) {
    return quarterOf(filaments(of.layers[layer])[0], 20).y();
  };
  EXPECT_NEAR(quarter(toolpath, 0), 1.0, 1e-12) << "layer 1 is odd";
  EXPECT_NEAR(quarter(toolpath, 1), 0.5, 1e-12);
  settings.first_wave = FirstWave::Cosine;
  const Toolpath other = makeScaffold("sinusoidal", settings);
  EXPECT_NEAR(quarter(other, 0), 0.5, 1e-12);
  EXPECT_NEAR(quarter(other, 1), 1.0, 1e-12);
}

TEST(SinusoidalTest, MirroredFilamentsSwingAgainstEachOther) {
  ScaffoldSettings settings = settingsOf();
  settings.arrangement = FilamentArrangement::Mirrored;
  const std::vector<Path> lines = filaments(makeScaffold("sinusoidal", settings).layers[0]);
  // The second one runs back, from the end of the length.
  const Point3 first = quarterOf(lines[0], 20);
  const Point3 second = lines[1].points[lines[1].points.size() - 1 - 5];
  EXPECT_NEAR(first.y() - 0.5, 0.5, 1e-12);
  EXPECT_NEAR(second.y() - 2.5, -0.5, 1e-12);
  EXPECT_NEAR(crossSection(lines[0].bead.at(0)), 0.98 * 0.48 * 0.3, 1e-12);
}

TEST(SinusoidalTest, ABeadIsAnEllipseOfWidthAndHeight) {
  const Toolpath toolpath = makeScaffold("sinusoidal", settingsOf());
  EXPECT_NEAR(crossSection(filaments(toolpath.layers[3])[2].bead.at(1)), M_PI / 4.0 * 0.48 * 0.3, 1e-12);
}

TEST(SinusoidalTest, LeavesThePartBetweenLayers) {
  const Toolpath toolpath = makeScaffold("sinusoidal", settingsOf());
  const Path& travel = toolpath.layers[1].paths.front();
  ASSERT_EQ(travel.role, PathRole::Travel);
  double least = 0.0;
  for (const Point3& point : travel.points) least = std::min(least, point.x());
  EXPECT_NEAR(least, -10.0, 1e-12);
}

TEST(SinusoidalTest, RefusesSettingsThatContradictEachOther) {
  ScaffoldSettings settings = settingsOf();
  settings.amplitude_mm = 4.6;
  EXPECT_THROW(makeScaffold("sinusoidal", settings), InvalidConfig);
  settings = settingsOf();
  settings.wave = ScaffoldWave::Cosine;
  settings.arrangement = FilamentArrangement::Mirrored;
  EXPECT_THROW(makeScaffold("sinusoidal", settings), InvalidConfig);
  settings = settingsOf();
  settings.bead_width_mm = 0.2;
  EXPECT_THROW(makeScaffold("sinusoidal", settings), InvalidConfig);
  settings = settingsOf();
  settings.filaments = 1;
  EXPECT_THROW(makeScaffold("sinusoidal", settings), InvalidConfig);
  EXPECT_THROW(makeScaffold("octagon", settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
