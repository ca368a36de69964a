// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/rising_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

constexpr double kRisingWallHeight = test::kLayerHeight;
constexpr double kRisingWallPitch = test::kLayerPitch;
constexpr int kRisingWallLayers = 20;

template <class Contours>
std::vector<Layer> layersOf(Contours contours) {
  return test::layersOf(kRisingWallLayers, contours);
}

std::vector<Layer> box() {
  return layersOf([](int) { return std::vector<Polygon>{rectangle(0, 0, 12, 12)}; });
}

std::vector<Layer> cone() {
  return layersOf([](int i) { return std::vector<Polygon>{circle({0, 0}, 10.0 - 0.1 * i, 90)}; });
}

Toolpath vaseOf(const std::vector<Layer>& layers, int base_layers) {
  PlanSettings settings;
  settings.infill.strategy = "vase";
  settings.skirt.count = 0;
  settings.fill.vase.base_layers = base_layers;
  NoProgress progress;
  Toolpath toolpath = planToolpath("vase", layers, settings, progress);
  validate(toolpath);
  return toolpath;
}

/// What the vase is refused for.
std::string risingWallRefusalOf(const std::vector<Layer>& layers) {
  try {
    vaseOf(layers, 2);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(RisingWall, IsOneRunWithoutTravel) {
  for (const std::vector<Layer>& part : {box(), cone()}) {
    const Toolpath toolpath = vaseOf(part, 0);
    EXPECT_EQ(totals(toolpath).travel_mm, 0.0);
    for (const ToolpathLayer& layer : toolpath.layers) EXPECT_EQ(layer.paths.size(), 1U);
  }
}

TEST(RisingWall, RisesInProportionToTheWayRound) {
  const Toolpath toolpath = vaseOf(box(), 0);
  for (std::size_t i = 0; i + 1 < toolpath.layers.size(); ++i) {
    const Path& turn = toolpath.layers[i].paths.front();
    const double whole = 4.0 * (12.0 - 0.4);
    double gone = 0.0;
    for (std::size_t k = 0; k < turn.points.size(); ++k) {
      if (k > 0) gone += (turn.points[k] - turn.points[k - 1]).head<2>().norm();
      EXPECT_NEAR(turn.points[k].z(), kRisingWallHeight * (static_cast<double>(i) + gone / whole), 1e-5);
    }
    EXPECT_NEAR(gone, whole, 1e-3);
  }
}

TEST(RisingWall, HoldsTheVolumeOfTheWall) {
  // What the first turn lacks the closing one at the top adds.
  const double wall = 4.0 * (12.0 - 0.4) * kRisingWallPitch * kRisingWallHeight * kRisingWallLayers;
  EXPECT_NEAR(totals(vaseOf(box(), 0)).deposited_mm3, wall, 1e-3 * wall);
}

TEST(RisingWall, BeginsAndEndsWithABeadOfNoHeight) {
  const Toolpath toolpath = vaseOf(box(), 0);
  const Path& first = toolpath.layers.front().paths.front();
  double volume = 0.0;
  for (std::size_t i = 1; i < first.points.size(); ++i)
    volume += crossSection(first.bead.at(i)) * (first.points[i] - first.points[i - 1]).norm();
  EXPECT_NEAR(volume, 0.5 * 4.0 * (12.0 - 0.4) * kRisingWallPitch * kRisingWallHeight, 1e-3 * volume);
  EXPECT_LT(first.bead.at(1).height_mm, 0.02 * kRisingWallHeight);
  const Path& last = toolpath.layers.back().paths.front();
  EXPECT_LT(last.bead.at(last.points.size() - 1).height_mm, 0.02 * kRisingWallHeight);
  EXPECT_EQ(last.points.back().z(), kRisingWallHeight * kRisingWallLayers);
}

TEST(RisingWall, HasNoStepBetweenTurnsOfACone) {
  const Toolpath toolpath = vaseOf(cone(), 0);
  for (std::size_t i = 1; i < toolpath.layers.size(); ++i) {
    const Point3& end = toolpath.layers[i - 1].paths.front().points.back();
    const Path& turn = toolpath.layers[i].paths.front();
    EXPECT_EQ(turn.points.front(), end);
    // The radius falls by 0.1 mm in a turn, a little at each motion.
    for (std::size_t k = 1; k < turn.points.size(); ++k) {
      const double step = std::abs(turn.points[k].head<2>().norm() - turn.points[k - 1].head<2>().norm());
      EXPECT_LT(step, 0.012) << "layer " << i << ", motion " << k;
    }
  }
}

TEST(RisingWall, StandsOnSolidLayers) {
  const Toolpath toolpath = vaseOf(box(), 3);
  double filled = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (const Path& path : toolpath.layers[i].paths) filled += depositedVolume(path);
  EXPECT_NEAR(filled, 3 * kRisingWallHeight * 12.0 * 12.0, 0.05 * filled);
  EXPECT_EQ(toolpath.layers[3].paths.back().role, PathRole::OuterWall);
  EXPECT_NEAR(toolpath.layers[3].paths.back().points.front().z(), 3 * kRisingWallHeight, 1e-9);
}

TEST(RisingWall, RefusesALayerOfTwoRegionsByItsNumber) {
  const std::string reported = risingWallRefusalOf(layersOf([](int i) {
    std::vector<Polygon> contours = {rectangle(0, 0, 5, 5)};
    if (i == 7) contours.push_back(rectangle(7, 0, 12, 5));
    return contours;
  }));
  EXPECT_NE(reported.find("layer 7 "), std::string::npos) << reported;
  EXPECT_NE(reported.find("2 regions"), std::string::npos) << reported;
}

TEST(RisingWall, RefusesAHoleByTheLayerItIsIn) {
  const std::string reported = risingWallRefusalOf(layersOf([](int i) {
    std::vector<Polygon> contours = {rectangle(0, 0, 12, 12)};
    if (i > 4) contours.push_back(reversed(circle({6, 6}, 3, 30)));
    return contours;
  }));
  EXPECT_NE(reported.find("layer 5 "), std::string::npos) << reported;
  EXPECT_NE(reported.find("1 hole"), std::string::npos) << reported;
}

TEST(RisingWall, RefusesALayerWithoutRoomBetweenOthers) {
  const std::string reported = risingWallRefusalOf(layersOf(
      [](int i) { return i == 6 ? std::vector<Polygon>{} : std::vector<Polygon>{rectangle(0, 0, 12, 12)}; }));
  EXPECT_NE(reported.find("layer 6 "), std::string::npos) << reported;
}

TEST(RisingWall, EndsWhereThePartDoes) {
  const Toolpath toolpath =
      vaseOf(layersOf([](int i) {
               return i > 15 ? std::vector<Polygon>{} : std::vector<Polygon>{rectangle(0, 0, 12, 12)};
             }),
             0);
  EXPECT_EQ(toolpath.layers[15].paths.front().points.back().z(), toolpath.layers[15].z_mm);
  EXPECT_TRUE(toolpath.layers[16].paths.empty());
}

TEST(RisingWall, IsWrittenWithAHeightOnEachMotion) {
  ProgramSettings settings;
  settings.start_code = "";
  settings.end_code = "";
  std::string text;
  Toolpath toolpath = vaseOf(box(), 0);
  toolpath.layers.resize(kRisingWallLayers - 1);  // without the turn at the top, which stays at its height
  writeGcode(toolpath, Eigen::Isometry3d::Identity(), settings,
             [&](std::string_view piece) { text += piece; });
  std::size_t motions = 0;
  double z = 0.0;
  for (std::size_t at = text.find("\nG1 "); at != std::string::npos; at = text.find("\nG1 ", at + 1)) {
    const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    const std::size_t word = line.find(" Z");
    ASSERT_NE(word, std::string::npos) << line;
    EXPECT_GT(std::stod(line.substr(word + 2)), z);
    z = std::stod(line.substr(word + 2));
    ++motions;
  }
  EXPECT_GT(motions, 64U * (kRisingWallLayers - 2));
}

}  // namespace
}  // namespace lamina
