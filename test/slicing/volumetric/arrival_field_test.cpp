// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/arrival_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "support/grown_parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kOverhangDeg = 30.0;

GrowthGauge usualGauge() { return GrowthGauge({toRadians(kOverhangDeg), 2.0, toRadians(80.0)}); }

struct Grown {
  CellGraph cells;
  ArrivalField field;
};

Grown grown(const Mesh& mesh, double cell_mm, const GrowthGauge& gauge = usualGauge()) {
  NoProgress progress;
  CellGraph cells(mesh, cell_mm, 0.0, progress);
  ArrivalField field = arrivalField(cells, gauge, {0.0, 0.1}, progress);
  return {std::move(cells), std::move(field)};
}

/// Greatest difference of the field from `truth(place)`, where `isAsked(place)`.
template <class Truth, class Asked>
double greatestError(const Grown& grown, const Truth& truth, const Asked& isAsked) {
  double greatest = 0.0;
  for (std::uint32_t node = 0; node < grown.cells.nodeCount(); ++node) {
    const Point3& place = grown.cells.middle(node);
    if (isAsked(place)) greatest = std::max(greatest, std::abs(grown.field.growth_mm[node] - truth(place)));
  }
  return greatest;
}

bool anywhere(const Point3&) { return true; }
double height(const Point3& place) { return place.z(); }

TEST(ArrivalField, IsLevelInABoxAndInACylinder) {
  EXPECT_LT(greatestError(grown(test::boxBetween({0, 0, 0}, {10.3, 8, 12}), 0.7), height, anywhere), 1e-9);
  const Mesh cylinder = makePart("cylinder", {{"radius_mm", "5"}, {"height_mm", "12"}});
  EXPECT_LT(greatestError(grown(cylinder, 0.5), height, anywhere), 1e-9);
}

TEST(ArrivalField, IsLevelInAConeAndInAFrustumThatOpensByLessThanTheOverhang) {
  const Mesh cone = makePart("cone", {{"radius_mm", "8"}, {"height_mm", "8"}});
  EXPECT_LT(greatestError(grown(cone, 0.5), height, anywhere), 1e-9);
  EXPECT_LT(greatestError(grown(test::openingFrustum(28.0, 12.0), 0.5), height, anywhere), 1e-9);
}

// About its rim, in the plane through the axis: level where ways lean no more than the overhang, else
// straight.
TEST(ArrivalField, FansOutAboutTheFootOfAFrustum) {
  const GrowthGauge gauge = usualGauge();
  for (const double lean : {45.0, 60.0, 75.0}) {
    const Grown part = grown(test::openingFrustum(lean, 10.0), 0.5);
    const auto truth = [&](const Point3& place) {
      const double beyond = std::max(0.0, place.head<2>().norm() - 10.0);
      return gauge.cost(Point3(beyond, 0.0, place.z()));
    };
    // The bits are steps of an eighth of a millimetre in the circle of the foot.
    EXPECT_LT(greatestError(part, truth, anywhere), 0.15) << lean;
  }
}

// About both re-entrant edges of the bar.
TEST(ArrivalField, FansOutIntoTheArmsOfAT) {
  const GrowthGauge gauge = usualGauge();
  const auto truth = [&](const Point3& place) {
    const double beyond = std::max(0.0, std::abs(place.x()) - 6.0);
    return place.z() < 20.0 ? place.z() : 20.0 + gauge.cost(Point3(beyond, 0.0, place.z() - 20.0));
  };
  for (const double cell : {1.0, 0.5})
    EXPECT_LT(greatestError(grown(test::tShape(), cell), truth, anywhere), 0.12 * cell) << cell;
}

// Both as if the other was not there.
TEST(ArrivalField, FansOutIntoBothArmsOfAY) {
  const GrowthGauge gauge = usualGauge();
  const auto truth = [&](const Point3& place) {
    const double beyond = std::max(0.0, std::abs(place.x()) - 6.0);
    return place.z() < 20.0 ? place.z() : 20.0 + gauge.cost(Point3(beyond, 0.0, place.z() - 20.0));
  };
  EXPECT_LT(greatestError(grown(test::yShape(), 0.5), truth, anywhere), 0.1 * 0.5);
}

// From the nearest place of the foot, a circle of 10 mm: the part is convex.
TEST(ArrivalField, IsTheCostFromTheFootOfALeaningCylinder) {
  const GrowthGauge gauge = usualGauge();
  for (const double lean_deg : {45.0, 60.0}) {
    Mesh cylinder = makePart("cylinder", {{"radius_mm", "10"}, {"height_mm", "14"}, {"segments", "256"}});
    for (Point3& vertex : cylinder.vertices) vertex.x() += std::tan(toRadians(lean_deg)) * vertex.z();
    const auto truth = [&](const Point3& place) {
      const double beyond = std::max(0.0, place.head<2>().norm() - 10.0);
      return gauge.cost(Point3(beyond, 0.0, place.z()));
    };
    EXPECT_LT(greatestError(grown(cylinder, 0.5), truth, anywhere), 0.15 * 0.5) << lean_deg;
  }
}

// The bits are other steps in it then.
TEST(ArrivalField, TurnsWithThePart) {
  const GrowthGauge gauge = usualGauge();
  const Eigen::Rotation2Dd turn(toRadians(37.0));
  Mesh turned = test::tShape();
  for (Point3& vertex : turned.vertices) vertex.head<2>() = turn * Point2(vertex.head<2>());
  const auto truth = [&](const Point3& place) {
    const Point2 before = turn.inverse() * Point2(place.head<2>());
    const double beyond = std::max(0.0, std::abs(before.x()) - 6.0);
    return place.z() < 20.0 ? place.z() : 20.0 + gauge.cost(Point3(beyond, 0.0, place.z() - 20.0));
  };
  EXPECT_LT(greatestError(grown(turned, 0.5), truth, anywhere), 0.21 * 0.5);
}

TEST(ArrivalField, TiltsUndersidesAsTheGaugeSays) {
  const Grown part = grown(test::tShape(), 0.5);
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
    const Point3& place = part.cells.middle(node);
    if (std::abs(place.x()) < 9.0 || place.z() < 20.0 || place.z() > 20.5) continue;
    const Point3 gradient = part.field.near(place, node, place, usualGauge()).gradient;
    const double tilt = toDegrees(std::atan2(gradient.head<2>().norm(), gradient.z()));
    EXPECT_NEAR(tilt, 60.0, 8.0);
    EXPECT_NEAR(1.0 / gradient.norm(), 1.83, 0.15);
  }
}

// Two plates 0.4 mm apart, joined at one end: growth goes round, not across.
TEST(ArrivalField, DoesNotJumpGapsNarrowerThanACell) {
  const Mesh plates = test::lyingPrism(
      {{{0, 0}, {4, 0}, {4, 20}, {4.4, 20}, {4.4, 4}, {8.4, 4}, {8.4, 24}, {0, 24}}, {}}, 4.0);
  const Grown part = grown(plates, 1.0);
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
    const Point3& place = part.cells.middle(node);
    if (place.x() < 4.5 || place.z() > 18.0) continue;
    EXPECT_GT(part.field.growth_mm[node], 20.0);
  }
}

TEST(ArrivalField, LeavesOutWhatHangs) {
  // An arm 10 mm out from a post, and a rod down from its end.
  const Mesh hook =
      test::lyingPrism({{{0, 0}, {8, 0}, {8, 20}, {18, 20}, {18, 8}, {24, 8}, {24, 26}, {0, 26}}, {}}, 6.0);
  const Grown part = grown(hook, 0.5);
  double pendant = 0.0;
  for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node)
    if (std::isinf(part.field.growth_mm[node])) pendant += part.cells.volume(node);
  // Of the rod, 6 x 6 x 12 mm, all below a line 20 deg down from its inner edge.
  const double reached = 0.5 * std::tan(toRadians(20.0)) * 6.0 * 6.0 * 6.0;
  EXPECT_NEAR(pendant, 6.0 * 6.0 * 12.0 - reached, 0.03 * 6.0 * 6.0 * 12.0);
}

/// A prism that bulges and leans; no corner of it lies where bits have their middles.
Mesh anyBody() {
  const double tall = 0.0137 + 0.1 * *rc::gen::inRange(42, 120);
  const double bulge = 0.1 * *rc::gen::inRange(-29, 60);
  const double over = 0.1 * *rc::gen::inRange(1, 60);
  return test::lyingPrism({{{-4, 0}, {4, 0}, {4 + bulge, 0.5 * tall}, {4 + over, tall}, {-4, tall}}, {}},
                          5.3117);
}

TEST(ArrivalField, OnlyGrowsFromWhatHasGrown) {
  EXPECT_TRUE(rc::check([] {
    const GrowthGauge gauge = usualGauge();
    const Grown part = grown(anyBody(), 0.8);
    for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node) {
      if (std::isinf(part.field.growth_mm[node]) || part.cells.middle(node).z() < 0.8) continue;
      bool has_earlier = false;
      for (const std::uint32_t near : part.cells.links(node))
        has_earlier = has_earlier || part.field.growth_mm[near] < part.field.growth_mm[node];
      RC_ASSERT(has_earlier);
      RC_ASSERT(part.field.growth_mm[node] >= part.cells.middle(node).z() - 1e-9);
      const Point3& place = part.cells.middle(node);
      const double thickness = 1.0 / part.field.near(place, node, place, gauge).gradient.norm();
      RC_ASSERT(thickness >= 1.0 - 1e-9);
      RC_ASSERT(thickness <= 2.0 + 1e-9);
    }
  }));
}

// What is grown to a node goes on to its neighbours in a straight way, give or take a bit.
TEST(ArrivalField, ChangesNoFasterThanTheGaugeSays) {
  EXPECT_TRUE(rc::check([] {
    const GrowthGauge gauge = usualGauge();
    const Grown part = grown(anyBody(), 0.8);
    for (std::uint32_t node = 0; node < part.cells.nodeCount(); ++node)
      for (const std::uint32_t near : part.cells.links(node)) {
        const double step = gauge.cost(part.cells.middle(near) - part.cells.middle(node));
        RC_ASSERT(!(part.field.growth_mm[near] > part.field.growth_mm[node] + step + 0.2));
      }
  }));
}

TEST(ArrivalField, IsTheSameForAnyNumberOfThreads) {
  const Mesh part = test::openingFrustum(60.0, 8.0);
  const Grown many = grown(part, 0.6);
  const ThreadLimit limit(1);
  const Grown one = grown(part, 0.6);
  EXPECT_EQ(many.field.growth_mm, one.field.growth_mm);
}

class Cancelling final : public Progress {
 public:
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return true; }
};

TEST(ArrivalField, CanBeCancelled) {
  NoProgress nobody;
  const CellGraph cells(test::boxBetween({0, 0, 0}, {20, 20, 20}), 0.8, 0.0, nobody);
  Cancelling progress;
  EXPECT_THROW(arrivalField(cells, usualGauge(), {0.0, 0.1}, progress), Cancelled);
}

}  // namespace
}  // namespace lamina
