// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/layer_travels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

/// 30 x 30 mm with a notch of 10 x 20 mm from the top.
const Polygon kLetterU = {{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};

TravelSettings combing() {
  TravelSettings settings;
  settings.comb = Combing::Inside;
  settings.keep_off_mm = 0.0;
  settings.comb_longest_mm = 100.0;
  return settings;
}

Path across(const TravelSettings& settings, const Regions& top_skin = {}) {
  const Regions material = {{kLetterU, {}}};
  LayerTravels travels(settings, 0.4);
  travels.setMaterial(material);
  travels.addSeen(top_skin);
  return travels.between({5, 28, 0.2}, {25, 28, 0.2}, TravelOver::Anything).value();
}

double highest(const Path& path) {
  double z = 0.0;
  for (const Point3& point : path.points) z = std::max(z, point.z());
  return z;
}

TEST(Combing, KeepsHalfABeadInside) {
  const Path path = across(combing());
  EXPECT_FALSE(path.process.is_retracted);
  // Round corners that lie half a bead off those of the part.
  EXPECT_NEAR(length(path), 2 * std::hypot(4.8, 18.2) + 10.4, 1e-3);
  EXPECT_EQ(highest(path), 0.2);
  TravelSettings off = combing();
  off.keep_off_mm = 0.5;
  EXPECT_NEAR(length(across(off)), 2 * std::hypot(4.3, 18.7) + 11.4, 1e-3);
}

TEST(Combing, GoesStraightWhereTheDetourIsTooLong) {
  TravelSettings settings = combing();
  settings.comb_detour = 2.0;
  const Path path = across(settings);
  EXPECT_TRUE(path.process.is_retracted);
  EXPECT_NEAR(length(path), 20.0 + 2 * settings.hop_mm, 1e-9);
}

TEST(Combing, RetractsLongWaysThatStayInside) {
  TravelSettings settings = combing();
  settings.comb_longest_mm = 30.0;
  const Path path = across(settings);
  EXPECT_TRUE(path.process.is_retracted);
  EXPECT_NEAR(length(path), 2 * std::hypot(4.8, 18.2) + 10.4 + 2 * settings.hop_mm, 1e-3);
  EXPECT_NEAR(highest(path), 0.2 + settings.hop_mm, 1e-12);
}

TEST(Combing, IsStraightToAnotherIsland) {
  const Regions material = {{rectangle(0, 0, 10, 10), {}}, {rectangle(12, 0, 22, 10), {}}};
  const TravelSettings settings = combing();
  LayerTravels travels(settings, 0.4);
  travels.setMaterial(material);
  const Path path = travels.between({5, 5, 0.2}, {15, 5, 0.2}, TravelOver::Anything).value();
  EXPECT_TRUE(path.process.is_retracted);
  EXPECT_EQ(path.points.size(), 4U);
}

TEST(Combing, AvoidsTopSkin) {
  TravelSettings settings = combing();
  const Regions skin = {{rectangle(8, 5, 22, 9.8), {}}};
  EXPECT_NEAR(length(across(settings, skin)), 2 * std::hypot(4.8, 18.2) + 10.4, 1e-3);
  settings.comb = Combing::NoSkin;
  settings.comb_detour = 4.0;
  const double below_mm = 14.0 + 2 * std::hypot(3, 23);
  EXPECT_NEAR(length(across(settings, skin)), below_mm, 1e-3) << "below the skin";
}

TEST(Combing, ChangesNothingWhereItIsNone) {
  const TravelSettings settings;
  const Path path = across(settings);
  const Path straight = makeTravel({5, 28, 0.2}, {25, 28, 0.2}, settings).value();
  EXPECT_EQ(path.points, straight.points);
  EXPECT_EQ(path.process.is_retracted, straight.process.is_retracted);
}

TEST(Hopping, IsOverTopSkinsAlone) {
  TravelSettings settings;
  settings.hop = Hopping::OverSkin;
  EXPECT_EQ(highest(across(settings)), 0.2);
  EXPECT_NEAR(highest(across(settings, {{rectangle(22, 20, 29, 29), {}}})), 0.4, 1e-12);
  EXPECT_EQ(highest(across(settings, {{rectangle(0, 0, 29, 9), {}}})), 0.2);
}

TEST(Hopping, IsNotWhereItIsNever) {
  PlanSettings settings;
  settings.travel.hop = Hopping::Never;
  settings.travel.hop_mm = 0.7;
  const Toolpath toolpath =
      test::plan(test::layersOf(3, [](int) { return std::vector<Polygon>{kLetterU}; }), settings);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) EXPECT_LE(highest(path), layer.z_mm + 1e-9);
}

/// Retracted travels within layers, and whether any that is not leaves the part.
struct Travels {
  int retracted = 0;
  bool leaves = false;
};

Travels travelsOf(const Toolpath& toolpath, const Regions& part) {
  Travels travels;
  const std::vector<Polygon> inside = outlines(offset(part, -0.18));
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 1; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      if (path.role != PathRole::Travel) continue;
      if (path.process.is_retracted) {
        ++travels.retracted;
        continue;
      }
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
        for (double share = 0.0; share <= 1.0; share += 0.02) {
          const Point3 point = path.points[i] + share * (path.points[i + 1] - path.points[i]);
          travels.leaves = travels.leaves || !contains(inside, point.head<2>());
        }
    }
  return travels;
}

TEST(Combing, KeepsThePlannedTravelsOfALayerInside) {
  const Regions part = {{kLetterU, {test::reversed(test::circle({5, 20}, 2, 48))}}};
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.travel.retraction_threshold_mm = 0.5;
  const auto planned = [&] {
    return test::plan(test::layersOf(4, [&](int) { return outlines(part); }), settings);
  };
  const Travels straight = travelsOf(planned(), part);
  settings.travel.comb = Combing::Inside;
  settings.travel.comb_longest_mm = 1000.0;
  settings.travel.comb_detour = 1000.0;
  const Travels combed = travelsOf(planned(), part);
  EXPECT_GT(straight.retracted, 4);
  EXPECT_EQ(combed.retracted, 0);
  EXPECT_FALSE(combed.leaves);
}

}  // namespace
}  // namespace lamina
