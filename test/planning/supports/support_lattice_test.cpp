// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/support_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lamina/geometry/polygon/polygon.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

const double kTan15 = std::tan(M_PI / 12.0);

/// A triangle whose sides rise by 15 deg from a tip, the one of beads in it at that height.
Region flatTriangle(double tip_of_beads_mm, double height_mm) {
  const double tip = tip_of_beads_mm - 0.5 * test::kLayerPitch / std::cos(M_PI / 12.0);
  const double half = height_mm / kTan15;
  return {{{0.0, tip}, {half, tip + height_mm}, {-half, tip + height_mm}}, {}};
}

/// What the lattice of a column deposits in one layer of 0.2 mm.
std::vector<FillPath> latticeIn(const Region& column) {
  PlanSettings settings;
  settings.supports.use = true;
  const SupportSection section{0.0, 0.2, std::make_shared<const Regions>(Regions{column}),
                               std::make_shared<const Regions>()};
  NoProgress nobody;
  const auto aids = supportLattice({{section}}, settings, LatticePlace{0.2, Point2::Zero()}, nobody);
  return aids.at(0).empty() ? std::vector<FillPath>{} : *aids.at(0).at(0).runs;
}

// Lines lie at y = 0, 2.38, 4.76 mm: 0.357 mm at a density of 0.15. Where sides rise by 15 deg it is 9.2 mm
// from one to the next, which is too far to be joined.

TEST(SupportLattice, LeavesOutTheLineThatIsNoLongerThanWide) {
  const std::vector<FillPath> runs = latticeIn(flatTriangle(-0.03, 6.0));
  const double spacing = test::kLayerPitch / 0.15;
  ASSERT_EQ(runs.size(), 2U) << "none of 0.22 mm at y = 0";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double y = static_cast<double>(i + 1) * spacing;
    EXPECT_NEAR(runs[i].points.front().y(), y, 1e-6);
    EXPECT_NEAR(length(runs[i].points), 2.0 * (y + 0.03) / kTan15, 0.01);
  }
}

TEST(SupportLattice, KeepsLinesLongerThanWide) {
  const std::vector<FillPath> runs = latticeIn(flatTriangle(-0.12, 6.0));
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_NEAR(length(runs[0].points), 0.24 / kTan15, 0.01) << "0.90 mm at y = 0";
}

/// A column of 40 x 40 mm, of which the right half lies in a region of twice the density, across, with a
/// loop.
TEST(SupportLattice, LaysTheLinesOfARegionWithinIt) {
  PlanSettings settings;
  settings.supports.use = true;
  const Region column{test::rectangle(0, 0, 40, 40), {}};
  const Regions right = {{test::rectangle(20, -5, 60, 50), {}}};
  std::vector<PlanVariant> variants = {{settings, {right, {}}}};
  const auto lengthsIn = [&](std::size_t layer, const std::vector<PlanVariant>* own) {
    const auto lattice = std::make_shared<const Regions>(Regions{column});
    const auto none = std::make_shared<const Regions>();
    const std::vector<LayerSupport> layers = {{{0.0, 0.2, lattice, none}}, {{0.2, 0.4, lattice, none}}};
    NoProgress nobody;
    LatticePlace place{0.2, Point2::Zero()};
    place.variants = own;
    const auto aids = supportLattice(layers, settings, place, nobody);
    std::pair<double, double> left_and_right;
    for (const AidRuns& group : aids.at(layer))
      for (const FillPath& run : *group.runs)
        for (std::size_t i = 1; i < run.points.size(); ++i) {
          const Point2& a = run.points[i - 1];
          const Point2& b = run.points[i];
          const double way = b.x() - a.x();
          const double share = std::abs(way) < 1e-9
                                   ? (a.x() < 20.0 ? 1.0 : 0.0)
                                   : std::clamp((20.0 - std::min(a.x(), b.x())) / std::abs(way), 0.0, 1.0);
          left_and_right.first += share * (b - a).norm();
          left_and_right.second += (1.0 - share) * (b - a).norm();
        }
    return left_and_right;
  };
  variants[0].settings.supports.density = 0.3;
  const auto [sparse, dense] = lengthsIn(0, &variants);
  EXPECT_NEAR(sparse, 20.0 * 40.0 * 0.15 / test::kLayerPitch, 40.0) << "within two lines";
  EXPECT_NEAR(dense / sparse, 2.0, 0.15);
  const auto [left, rest] = lengthsIn(1, &variants);
  EXPECT_NEAR(rest / left, 1.0, 0.1) << "the region ends below";
  variants[0].settings.supports = settings.supports;
  EXPECT_EQ(lengthsIn(0, &variants), lengthsIn(0, nullptr)) << "a region with the same lines is none";
}

}  // namespace
}  // namespace lamina
