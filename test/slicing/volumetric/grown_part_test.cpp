// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/grown_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "support/grown_parts.hpp"
#include "support/lofted_solid.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kLayerMm = 0.25;

// 8 mm2 in a layer of 0.25 mm are 2 mm3.
TEST(GrownPart, LosesNoMoreVolumeThanALayerOverTheSurfaceThatIsSupportedInstead) {
  const GrowthLoss best{20.0, 1.0};
  EXPECT_TRUE(supportsMore({12.0, 1.0}, best, kLayerMm));
  EXPECT_TRUE(supportsMore({12.0, 3.0}, best, kLayerMm));
  EXPECT_FALSE(supportsMore({12.0, 3.01}, best, kLayerMm));
}

TEST(GrownPart, IsNoBetterWhereNoMoreIsSupported) {
  const GrowthLoss best{20.0, 1.0};
  EXPECT_FALSE(supportsMore(best, best, kLayerMm));
  EXPECT_FALSE(supportsMore({20.0, 0.0}, best, kLayerMm));
  EXPECT_FALSE(supportsMore({21.0, 0.0}, best, kLayerMm));
}

// What is no longer lost counts for what is supported besides.
TEST(GrownPart, IsBetterWhereMoreIsSupportedAndLessIsLost) {
  EXPECT_TRUE(supportsMore({19.9, 0.0}, {20.0, 1.0}, kLayerMm));
}

/// What a part leaves unsupported, grown without a head.
struct Hung {
  double surface_mm2;
  double level_mm2;
  double grown_mm2;
  std::size_t minima;
  Mesh where;
};

Hung hungOf(const Mesh& mesh, double cell_mm) {
  VolumetricRequest request;
  request.settings.cell_mm = cell_mm;
  request.settings.overhang_used_deg = 25.0;
  NoProgress progress;
  const GrownPart part = grownPart(mesh, request, progress);
  return {part.hanging.surface_mm2, part.hanging.level_mm2, part.hanging.grown_mm2,
          growthMinima(part.cells(), *part.lattice, part.bed_mm), part.hanging.grown};
}

// The undersides of the arms, 15 mm out and 60 deg from upright, 8 mm deep.
TEST(GrownPart, SupportsTheArmsOfAY) {
  const Hung hung = hungOf(test::yShape(), 0.5);
  const double undersides_mm2 = 2.0 * 8.0 * 15.0 / std::sin(M_PI / 3.0);
  EXPECT_NEAR(hung.level_mm2, undersides_mm2, 0.02 * undersides_mm2);
  EXPECT_LT(hung.grown_mm2, 0.005 * hung.surface_mm2);
  EXPECT_EQ(hung.minima, 0U);
}

// The lintel of a cube of 20 mm with a window of 10 mm through it: 200 mm² of 2600 that do not stand on the
// bed. Two cells are left beside the crest in which fronts meet, and beside both edges about which they fan.
TEST(GrownPart, SupportsTheLintelOfAWindowButWhereFrontsMeet) {
  const Mesh cube = test::lyingPrism(
      {{{-10, 0}, {10, 0}, {10, 20}, {-10, 20}}, {{{-5, 5}, {-5, 15}, {5, 15}, {5, 5}}}}, 20.0);
  const Hung hung = hungOf(cube, 0.5);
  EXPECT_NEAR(hung.surface_mm2, 2600.0, 20.0);
  EXPECT_NEAR(hung.level_mm2, 200.0, 4.0);
  EXPECT_LT(hung.grown_mm2, 50.0);
  for (const Triangle& corner : hung.where.triangles) {
    const std::vector<Point3>& at = hung.where.vertices;
    const double x = std::abs((at[corner[0]] + at[corner[1]] + at[corner[2]]).x() / 3.0);
    EXPECT_LT(std::min(x, std::abs(5.0 - x)), 2.0 * 0.5) << x;
  }
}

// Half a ring of 22 to 38 mm and 8 mm deep on both ends: level layers leave the quarter at its crown.
TEST(GrownPart, SupportsAnArchOnBothFeet) {
  Region arch;
  constexpr int kSides = 60;
  arch.outer.reserve(std::size_t{2} * (kSides + 1));
  for (int i = 0; i <= kSides; ++i)
    arch.outer.push_back(38.0 * Point2(std::cos(M_PI * i / kSides), std::sin(M_PI * i / kSides)));
  for (int i = kSides; i >= 0; --i)
    arch.outer.push_back(22.0 * Point2(std::cos(M_PI * i / kSides), std::sin(M_PI * i / kSides)));
  const Hung hung = hungOf(test::lyingPrism(arch, 8.0), 0.8);
  const double crown_mm2 = 8.0 * 22.0 * M_PI_2;
  EXPECT_NEAR(hung.level_mm2, crown_mm2, 0.02 * crown_mm2);
  EXPECT_LT(hung.grown_mm2, 0.01 * hung.surface_mm2);
  EXPECT_EQ(hung.minima, 0U);
}

// A ball of 10 mm cut flat, with a hollow of 6 mm in it: fronts close above the hollow.
TEST(GrownPart, ClosesAboveAHollow) {
  std::vector<double> heights;
  constexpr int kRings = 24;
  heights.reserve(kRings + 1);
  for (int i = 0; i <= kRings; ++i) heights.push_back(7.5 - 9.99 * std::cos(M_PI * i / kRings));
  heights.front() = 0.0;
  heights.erase(std::remove_if(heights.begin() + 1, heights.end(), [](double z) { return z <= 0.0; }),
                heights.end());
  const auto ball = [](double radius_mm) {
    return [radius_mm](double, double z) {
      return std::sqrt(std::max(0.01, radius_mm * radius_mm - (z - 7.5) * (z - 7.5)));
    };
  };
  std::vector<double> inner;
  inner.reserve(kRings + 1);
  for (int i = 0; i <= kRings; ++i) inner.push_back(7.5 - 5.99 * std::cos(M_PI * i / kRings));
  const Mesh shell = joined(test::loftedSolid(heights, 48, ball(10.0)),
                            test::turnedInsideOut(test::loftedSolid(inner, 48, ball(6.0))));
  const Hung hung = hungOf(shell, 0.5);
  // The ceiling of the hollow, and the ball's own underside between the first layer and 45 deg.
  const double ceiling_mm2 = 2.0 * M_PI * 6.0 * 6.0 * (1.0 - std::sqrt(0.5));
  const double below_mm2 = 2.0 * M_PI * 10.0 * (7.5 - 10.0 * std::sqrt(0.5) - 0.2);
  EXPECT_NEAR(hung.level_mm2, ceiling_mm2 + below_mm2, 5.0);
  EXPECT_LT(hung.grown_mm2, 0.35 * hung.level_mm2);
  EXPECT_EQ(hung.minima, 0U);
}

/// Counts how often a stage begins.
class Beginnings final : public Progress {
 public:
  explicit Beginnings(std::string stage) : stage_(std::move(stage)) {}
  void report(const std::string& stage, double) override {
    if (stage == stage_ && last_ != stage_) ++count_;
    last_ = stage;
  }
  bool isCancelled() const override { return false; }
  int count() const { return count_; }

 private:
  std::string stage_;
  std::string last_;
  int count_ = 0;
};

/// The cube with a window, in coarse cells: less overhang is used in steps of 2.5 deg from 25 deg on.
TEST(GrownPart, MakesCellsOnceForAllOverhangsTried) {
  const Mesh cube = test::lyingPrism(
      {{{-10, 0}, {10, 0}, {10, 20}, {-10, 20}}, {{{-5, 5}, {-5, 15}, {5, 15}, {5, 5}}}}, 20.0);
  VolumetricRequest request;
  request.settings.cell_mm = 1.0;
  Beginnings made("voxelise");
  EXPECT_LT(grownPart(cube, request, made).overhang_rad, toRadians(24.0)) << "more than one was tried";
  EXPECT_EQ(made.count(), 1);
}

// A block of 10 mm from x = 20 mm on, and a post of 2 mm that is as high at x = 0.
TEST(GrownCells, KnowTheLeastGrowthAroundAPlace) {
  const Mesh post = test::boxBetween({0, 0, 0}, {2, 2, 30});
  const Mesh part = joined(post, test::boxBetween({20, 0, 0}, {30, 10, 10}));
  VolumetricRequest request;
  request.settings.cell_mm = 0.5;
  NoProgress nobody;
  const GrownPart grown = grownPart(part, request, nobody);
  for (double x = -20.0; x < 50.0; x += 1.7)
    for (double z = -10.0; z < 45.0; z += 1.7) {
      const Point3 place(x, 1.0, z);
      const double least = grown.grown->leastAround(place);
      for (const Point3& aside : {Point3(7.9, 0, 0), Point3(-7.9, 0, 0), Point3(0, 0, 7.9),
                                  Point3(0, 0, -7.9), Point3(4.5, 4.5, -4.5), Point3(0, 0, 0)})
        EXPECT_LE(least, grown.grown->at(place + aside)) << place.transpose() << ", " << aside.transpose();
    }
  EXPECT_GT(grown.grown->leastAround({1, 1, 28}), 10.0) << "only what is 20 mm below is less";
  EXPECT_TRUE(std::isinf(grown.grown->leastAround({25, 5, 35}))) << "25 mm above the block";
}

}  // namespace
}  // namespace lamina
