// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/planning/planner.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kWidth = 0.4;

/// A ring and two islands that change from layer to layer, now and then with nothing in between.
std::vector<Layer> randomPart(Random& random) {
  std::vector<Layer> layers;
  for (int i = 0; i < 6; ++i) {
    Layer layer{{0.2 * i, 0.2 * (i + 1)}, {}};
    if (random.below(5) != 0)
      layer.section.contours = {test::star(random, {0, 0}, 7.0, 12.0, 40),
                                test::reversed(test::star(random, {0, 0}, 2.0, 4.0, 20)),
                                test::star(random, {25, 3}, 0.1, 3.0, 7), test::circle({-20, 0}, 2.0, 50)};
    layers.push_back(std::move(layer));
  }
  return layers;
}

PlanSettings randomSettings(Random& random) {
  PlanSettings settings;
  settings.walls.count = static_cast<int>(random.below(4));
  settings.walls.order = random.below(2) == 0 ? WallOrder::OutsideIn : WallOrder::InsideOut;
  settings.infill.density = random.below(4) == 0 ? 0.0 : random.uniform(0.05, 1.0);
  settings.infill.angle_deg = random.uniform(-180.0, 180.0);
  settings.infill.wall_overlap = random.uniform(0.0, 0.5);
  settings.bead.pitch_mm = random.uniform(0.28, 0.4);
  settings.skirt.count = static_cast<int>(random.below(3));
  settings.seam.placement = static_cast<SeamPlacement>(random.below(5));
  settings.travel.hop_mm = random.uniform(0.0, 1.0);
  settings.travel.retraction_threshold_mm = random.uniform(0.0, 5.0);
  return settings;
}

Toolpath planOf(const std::vector<Layer>& layers, const PlanSettings& settings) {
  NoProgress progress;
  return planToolpath("part", layers, settings, progress);
}

/// Whether all centre lines of the part lie half a bead inside its outlines, but for what these may be
/// simplified, and for narrow beads the steps in which their width changes and the tolerance of their axis.
bool isInside(const Path& path, const std::vector<Polygon>& borders, const PlanSettings& settings) {
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const double width = path.bead.at(i == 0 && !path.is_closed ? 1 : i).width_mm;
    const double step = path.bead.isCommon() ? 0.0 : (0.025 + 0.01) * kWidth;
    const double least = 0.5 * std::min(kWidth, width) - step - 2.0 * settings.simplification_mm - 1e-4;
    const Point2 flat = path.points[i].head<2>();
    if (!contains(borders, flat) || test::distanceToOutline(borders, flat) < least) return false;
  }
  return true;
}

/// Whether all of a part does.
bool isInside(const Toolpath& toolpath, const std::vector<Layer>& layers, const PlanSettings& settings) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::vector<Polygon> borders = outlines(unite(layers[i].section.contours));
    for (const Path& path : toolpath.layers[i].paths)
      if (path.role != PathRole::Travel && path.role != PathRole::Skirt && !isInside(path, borders, settings))
        return false;
  }
  return true;
}

TEST(PlannerProperties, EveryPlanIsValidAndStaysInsideThePart) {
  EXPECT_TRUE(rc::check("any part and settings", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Layer> layers = randomPart(random);
    const PlanSettings settings = randomSettings(random);
    const Toolpath toolpath = planOf(layers, settings);
    validate(toolpath);
    RC_ASSERT(toolpath.layers.size() == layers.size());
    RC_ASSERT(isInside(toolpath, layers, settings));
  }));
}

TEST(PlannerProperties, LanesStayInsideWhereTheirAxisBends) {
  // Two lanes turn by 67 deg round a corner that is as near as the part is thick there.
  Random random(343767503073755833U);
  const std::vector<Layer> layers = randomPart(random);
  const PlanSettings settings = randomSettings(random);
  EXPECT_TRUE(isInside(planOf(layers, settings), layers, settings));
}

TEST(PlannerProperties, EveryPlanIsTheSameForOneThreadAndForMany) {
  EXPECT_TRUE(rc::check("any part and settings", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Layer> layers = randomPart(random);
    const PlanSettings settings = randomSettings(random);
    const std::string id = toolpathId(planOf(layers, settings));
    const ThreadLimit one_thread(1);
    RC_ASSERT(toolpathId(planOf(layers, settings)) == id);
  }));
}

TEST(PlannerProperties, TravelsAndRunsTakeTurnsAndSkirtsAreInTheFirstLayerOnly) {
  EXPECT_TRUE(rc::check("any part and settings", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Toolpath toolpath = planOf(randomPart(random), randomSettings(random));
    const Path* previous = nullptr;
    for (std::size_t i = 0; i < toolpath.layers.size(); ++i) {
      for (const Path& path : toolpath.layers[i].paths) {
        RC_ASSERT(path.role != PathRole::Skirt || i == 0);
        if (previous != nullptr)
          RC_ASSERT(previous->role != PathRole::Travel || path.role != PathRole::Travel);
        previous = &path;
      }
    }
    if (previous != nullptr) RC_ASSERT(previous->role != PathRole::Travel);
  }));
}

}  // namespace
}  // namespace lamina
