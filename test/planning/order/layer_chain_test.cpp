// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/layer_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::layersOf;
using test::plan;
using test::rectangle;
using test::reversed;

constexpr double kHeight = test::kLayerHeight;
constexpr double kPitch = test::kLayerPitch;

struct NamedPart {
  std::string name;
  std::vector<Layer> layers;
};

/// The parts of [Guacheta2021, figures 3-13 to 3-19].
std::vector<NamedPart> parts() {
  const Polygon disc = circle({0, 0}, 8, 90);
  const Polygon hole = reversed(rectangle(-3, -3, 3, 3));
  return {{"cylinder", layersOf(30, [&](int) { return std::vector<Polygon>{disc}; })},
          {"cube", layersOf(30, [](int) { return std::vector<Polygon>{rectangle(0, 0, 12, 12)}; })},
          {"pyramid", layersOf(30,
                               [](int i) {
                                 const double half = 8.0 - 0.2 * i;
                                 return std::vector<Polygon>{rectangle(-half, -half, half, half)};
                               })},
          {"through hole", layersOf(30,
                                    [&](int) {
                                      return std::vector<Polygon>{disc, hole};
                                    })},
          {"hole from half height",
           layersOf(30,
                    [&](int i) {
                      return i < 15 ? std::vector<Polygon>{disc} : std::vector<Polygon>{disc, hole};
                    })},
          {"hole up to half height", layersOf(30, [&](int i) {
             return i < 15 ? std::vector<Polygon>{disc, hole} : std::vector<Polygon>{disc};
           })}};
}

PlanSettings contoursOnly() {
  PlanSettings settings;
  settings.infill.strategy = "contour";
  settings.infill.density = 1.0;
  settings.walls.count = 0;
  settings.skirt.count = 0;
  return settings;
}

// [Guacheta2021, algorithm 3-3]
TEST(LayerChain, MakesOnePathWithoutTravelOfAPartOfOneRegionPerLayer) {
  for (const NamedPart& part : parts()) {
    const ToolpathTotals sums = totals(plan(part.layers, contoursOnly()));
    EXPECT_EQ(sums.travel_mm, 0.0) << part.name;
    EXPECT_EQ(sums.deposition_runs, part.layers.size()) << part.name;
  }
}

/// A ball of 4 mm, and cones, which end in a point: each layer is cut half way up.
std::vector<NamedPart> pointedParts() {
  const auto middle = [](int i) { return kHeight * (i + 0.5); };
  const auto ball = [&](int i) {
    const double up = middle(i) - 4.0;
    return std::vector<Polygon>{circle({0, 0}, std::sqrt(16.0 - up * up), 128)};
  };
  const auto cone = [&](double base_mm, int i) {
    return std::vector<Polygon>{circle({0, 0}, base_mm * (1.0 - middle(i) / 4.0), 128)};
  };
  return {{"ball", layersOf(40, ball)},
          {"cone", layersOf(19, [&](int i) { return cone(5.0, i); })},
          {"flat cone", layersOf(18, [&](int i) { return cone(8.0, i); })}};
}

// [Guacheta2021, figures 3-13 to 3-19]
TEST(LayerChain, LaysNoPointOutsideTheOutline) {
  std::vector<NamedPart> all = parts();
  for (NamedPart& part : pointedParts()) all.push_back(std::move(part));
  for (const NamedPart& part : all) {
    const Toolpath toolpath = plan(part.layers, contoursOnly());
    for (std::size_t i = 0; i < part.layers.size(); ++i) {
      const std::vector<Polygon>& outline = part.layers[i].section.contours;
      for (const Path& path : toolpath.layers[i].paths)
        for (const Point3& point : path.points)
          ASSERT_TRUE(path.role == PathRole::Travel || contains(outline, point.head<2>()))
              << part.name << ", layer " << i;
    }
  }
}

TEST(LayerChain, RisesOnlyFromPlacesOfABeadWithinTheNextLayer) {
  constexpr double kWidth = 0.4;
  for (const NamedPart& part : pointedParts()) {
    const Toolpath toolpath = plan(part.layers, contoursOnly());
    std::size_t rises = 0;
    for (std::size_t i = 1; i < part.layers.size(); ++i)
      for (const Path& path : toolpath.layers[i].paths) {
        if (path.role == PathRole::Travel || path.points[0].z() > toolpath.layers[i].z_mm - 1e-9) continue;
        ++rises;
        const double radius = part.layers[i].section.contours[0][0].norm();
        EXPECT_LE(path.points[0].head<2>().norm() + 0.5 * kWidth, radius + 0.05 * kWidth + 1e-3)
            << part.name << ", layer " << i;
      }
    EXPECT_GE(rises + 3, part.layers.size()) << part.name;
  }
}

// [Guacheta2021, algorithm 3-3]
TEST(LayerChain, BeginsEachLayerWhereTheOneBelowEnded) {
  for (const NamedPart& part : parts()) {
    const Toolpath toolpath = plan(part.layers, contoursOnly());
    for (std::size_t i = 1; i < part.layers.size(); ++i) {
      ASSERT_EQ(toolpath.layers[i].paths.size(), 1U) << part.name << ", layer " << i;
      const Path& path = toolpath.layers[i].paths.front();
      EXPECT_EQ(path.firstPoint(), toolpath.layers[i - 1].paths.back().lastPoint())
          << part.name << ", layer " << i;
      EXPECT_TRUE(contains(part.layers[i - 1].section.contours, path.firstPoint().head<2>()))
          << part.name << ", layer " << i;
      EXPECT_LE((path.points[1] - path.points[0]).head<2>().norm(), kPitch)
          << part.name << ": the way up to layer " << i;
      EXPECT_NEAR(path.points[1].z() - path.points[0].z(), kHeight, 1e-9) << part.name << ", layer " << i;
    }
  }
}

TEST(LayerChain, LeavesNineTenthsOfAPitchOfEachCycleOut) {
  const std::vector<Layer> cube =
      layersOf(4, [](int) { return std::vector<Polygon>{rectangle(0, 0, 12, 12)}; });
  const Toolpath toolpath = plan(cube, contoursOnly());
  ASSERT_EQ(toolpath.layers.size(), 4U);
  for (const ToolpathLayer& layer : toolpath.layers) {
    ASSERT_EQ(layer.paths.size(), 1U);
    const Path& path = layer.paths.front();
    EXPECT_FALSE(path.is_closed);
    const Point3& start = path.points[path.points.front().z() < layer.z_mm ? 1 : 0];
    EXPECT_NEAR((path.points.back() - start).norm(), 0.9 * kPitch, 0.05 * kPitch);
  }
}

TEST(LayerChain, TravelsWhereTheNextLayerIsFar) {
  const std::vector<Layer> steps = layersOf(2, [](int i) {
    return std::vector<Polygon>{i == 0 ? rectangle(0, 0, 5, 5) : rectangle(20, 0, 25, 5)};
  });
  const Toolpath toolpath = plan(steps, contoursOnly());
  ASSERT_EQ(toolpath.layers[1].paths.size(), 2U);
  EXPECT_EQ(toolpath.layers[1].paths[0].role, PathRole::Travel);
}

TEST(LayerChain, KeepsTravelsBetweenTheRegionsOfALayer) {
  const std::vector<Layer> pair = layersOf(5, [](int) {
    return std::vector<Polygon>{rectangle(0, 0, 5, 5), rectangle(7, 0, 12, 5)};
  });
  for (const ToolpathLayer& layer : plan(pair, contoursOnly()).layers) {
    std::size_t runs = 0;
    for (const Path& path : layer.paths) runs += path.role == PathRole::Infill ? 1 : 0;
    EXPECT_EQ(runs, 2U);
  }
}

}  // namespace
}  // namespace lamina
