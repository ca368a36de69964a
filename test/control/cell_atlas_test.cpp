// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/cell_atlas.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "support/control_layers.hpp"
#include "support/measured_layers.hpp"

namespace lamina {
namespace {

constexpr Bead kBead{1.2, 0.3};

std::shared_ptr<const LayerCells> shared(LayerCells cells) {
  return std::make_shared<const LayerCells>(std::move(cells));
}

CellAtlas atlasOf(const test::MeasuredLayer& measured) {
  CellAtlas atlas;
  atlas.add(shared(test::cellsOf(measured)));
  return atlas;
}

std::size_t beadOf(const LayerCells& cells, std::size_t cell) {
  std::size_t bead = 0;
  while (cell >= cells.runs[bead].first + cells.runs[bead].count) ++bead;
  return bead;
}

TEST(CellAtlas, MeasuresHeightsExactlyAtCrowns) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(12, kBead)) {
    const CellAtlas atlas = atlasOf(measured);
    Random random(3);
    for (int i = 0; i < 3000; ++i) {
      const std::size_t bead = random.below(measured.beads);
      const double error = random.uniform(-0.3, 0.3);
      const PointSights sights = atlas.look(measured.place(bead, random.uniform(0.01, 0.99), 0.0, error));
      ASSERT_TRUE(sights.newest) << measured.name;
      EXPECT_FALSE(sights.below);
      ASSERT_NEAR(sights.newest->error_mm, error, 1e-6) << measured.name;
      ASSERT_NEAR(sights.newest->across_mm, 0.0, 1e-3) << measured.name;
    }
  }
}

TEST(CellAtlas, FindsTheRightBeadAndCell) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(12, kBead)) {
    const CellAtlas atlas = atlasOf(measured);
    const LayerCells& cells = *atlas.cellsOf(0);
    Random random(4);
    int right = 0;
    int right_cell = 0;
    constexpr int kAll = 20000;
    for (int i = 0; i < kAll; ++i) {
      const std::size_t bead = random.below(measured.beads);
      const double way = random.uniform(0.0, 1.0);
      const double across = random.uniform(-0.5, 0.5) * kBead.width_mm;
      const PointSights sights = atlas.look(measured.place(bead, way, across, random.uniform(-0.3, 0.3)));
      if (!sights.newest || beadOf(cells, sights.newest->cell) != bead) continue;
      ++right;
      const CellRun& run = cells.runs[bead];
      const auto cell = run.first + static_cast<std::size_t>(way * static_cast<double>(run.count));
      right_cell += sights.newest->cell == cell && sights.newest->across_mm * across >= 0.0 ? 1 : 0;
    }
    EXPECT_GE(right, 0.999 * kAll) << measured.name;
    EXPECT_GE(right_cell, 0.995 * kAll) << measured.name;
  }
}

TEST(CellAtlas, KnowsHowFarAlongAndAcrossAPointLies) {
  CellAtlas atlas;
  atlas.add(shared(test::straightBeads({0.0, 3.0}, 10.0, 0.5)));
  const auto on = atlas.look({4.1, 3.4, 1.3}).newest;
  ASSERT_TRUE(on);
  EXPECT_EQ(on->cell, 28U);
  EXPECT_NEAR(atlas.cellsOf(on->layer)->along_mm[on->cell] + on->off_mm, 4.1, 1e-5);
  EXPECT_NEAR(on->across_mm, 0.4, 1e-5);
  EXPECT_NEAR(on->across_share, 0.4 / 3.0, 1e-5);
  EXPECT_NEAR(on->error_mm, 0.2, 1e-9);
}

/// Rings about a rod, the nozzle square to it: growth goes all ways round.
TEST(CellAtlas, MeasuresLayersThatGoAllTheWayRound) {
  constexpr double kRadius = 10.0;
  ToolpathLayer layer{kRadius, kBead.height_mm, {}};
  const auto out = [](double way) {
    return Eigen::Vector3d(0.0, std::cos(2.0 * M_PI * way), std::sin(2.0 * M_PI * way));
  };
  for (int ring = 0; ring < 5; ++ring) {
    Path path = test::measuredBead(kBead);
    path.is_closed = true;
    std::vector<Eigen::Quaterniond> held;
    for (int k = 0; k < 252; ++k) {  // 126 cells
      path.points.push_back(kRadius * out(k / 252.0) + ring * kBead.width_mm * Eigen::Vector3d::UnitX());
      held.push_back(shortestRotation(Eigen::Vector3d::UnitZ(), -out(k / 252.0)));
    }
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(held));
    layer.paths.push_back(path);
  }
  CellAtlas atlas;
  atlas.add(shared(layerCells(layer, 0, 0.5)));
  ASSERT_EQ(atlas.cellsOf(0)->size(), 5U * 126U);
  EXPECT_FALSE(atlas.isPlane(0));
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const std::size_t ring = random.below(5);
    const double error = random.uniform(-0.3, 0.3);
    const double across = random.uniform(-0.59, 0.59);
    const Point3 point = (kRadius - error) * out(random.uniform(0.0, 1.0)) +
                         (double(ring) * kBead.width_mm + across) * Eigen::Vector3d::UnitX();
    const auto on = atlas.newestAt(point);
    ASSERT_TRUE(on);
    EXPECT_EQ(beadOf(*atlas.cellsOf(0), on->cell), ring);
    ASSERT_NEAR(on->error_mm, error, 1e-6);
  }
}

TEST(CellAtlas, LooksNoFartherThanACellReaches) {
  CellAtlas atlas(1.5);
  atlas.add(shared(test::straightBeads({0.0}, 10.0, 0.5)));
  EXPECT_TRUE(atlas.look({5.0, 0.0, 1.5 + 2.24}).newest);
  EXPECT_FALSE(atlas.look({5.0, 0.0, 1.5 + 2.26}).newest);
  EXPECT_TRUE(atlas.look({5.0, 1.49, 1.5}).newest);
  EXPECT_FALSE(atlas.look({5.0, 1.54, 1.5}).newest);
  EXPECT_FALSE(atlas.look({10.3, 0.0, 1.5}).newest);
}

TEST(CellAtlas, TakesTheNewestDepositedCellAndTheOneBelow) {
  CellAtlas atlas;
  for (const std::size_t k : {2U, 0U, 1U})
    atlas.add(shared(layerCells(test::straightBeadLayer({0.0}, 10.0, 1.5 * double(k + 1)), k, 0.5)));
  EXPECT_EQ(atlas.layers(), (std::vector<std::size_t>{0, 1, 2}));
  const Point3 point(5.1, 0.0, 3.5);  // tops lie at 1.5, 3 and 4.5
  PointSights sights = atlas.look(point);
  EXPECT_EQ(sights.newest->layer, 2U);
  EXPECT_NEAR(sights.newest->error_mm, 1.0, 1e-12);
  EXPECT_EQ(sights.below->layer, 1U);
  atlas.setDeposited(2, 10);
  EXPECT_EQ(atlas.look(point).newest->layer, 1U) << "the nozzle has not come so far";
  EXPECT_EQ(atlas.look({4.9, 0.0, 3.5}).newest->layer, 2U);
  atlas.forgetBelow(2);
  EXPECT_FALSE(atlas.look(point).newest);
  EXPECT_FALSE(atlas.look({4.9, 0.0, 3.5}).below);
}

TEST(CellAtlas, PutsALayerInPlaceOfOneOfTheSameNumber) {
  CellAtlas atlas;
  atlas.add(shared(test::straightBeads({0.0}, 10.0, 0.5)));
  atlas.add(shared(test::straightBeads({30.0}, 10.0, 0.5)));
  EXPECT_EQ(atlas.layers().size(), 1U);
  EXPECT_FALSE(atlas.look({5.0, 0.0, 1.5}).newest);
  EXPECT_TRUE(atlas.look({5.0, 30.0, 1.5}).newest);
}

/// Cells as long as beads are wide, and as far apart: a cell reaches 1.53 by 1.02 squares of the index, so
/// two by two, where it begins at an edge up to rounding.
TEST(CellAtlas, ListsCellsThatBeginAtTheEdgesOfSquaresInTwoByTwo) {
  std::vector<double> beads_y;
  for (int k = 0; k < 100; ++k) beads_y.push_back(0.1 + 3.0 * k);
  CellAtlas atlas;
  atlas.add(shared(test::straightBeads(beads_y, 300.0, 3.0)));
  const std::size_t cells = atlas.cellsOf(0)->size();
  ASSERT_EQ(cells, 10000U);
  const std::size_t squares = std::size_t{101} * 101;
  const std::size_t straight = 4 * squares + 64 * beads_y.size() + 16 * (beads_y.size() + 2);
  EXPECT_LE(atlas.bytes(), 32 * cells + 4 * (4 * cells + squares + 1) + 4 + straight);
}

TEST(CellAtlas, GivesWhatTwoBeadsShareToTheNearerAndOfEqualsToTheFirst) {
  CellAtlas atlas;
  atlas.add(shared(test::straightBeads({0.0, 2.0}, 10.0, 0.5)));  // 3 mm wide: 1 mm is shared
  EXPECT_EQ(atlas.look({5.1, 0.9, 1.5}).newest->cell, 10U);
  EXPECT_EQ(atlas.look({5.1, 1.1, 1.5}).newest->cell, 30U);
  EXPECT_EQ(atlas.look({5.1, 1.0, 1.5}).newest->cell, 10U);
}

TEST(CellAtlas, RefusesWhatItCannotWorkWith) {
  EXPECT_THROW(CellAtlas(0.0), InvalidInput);
  EXPECT_THROW(CellAtlas{std::numeric_limits<double>::quiet_NaN()}, InvalidInput);
  CellAtlas atlas;
  EXPECT_THROW(atlas.add(nullptr), InvalidInput);
  atlas.add(shared(LayerCells()));
  EXPECT_FALSE(atlas.look({0, 0, 0}).newest);
}

TEST(CellAtlas, NeverFindsACellForAPointThatIsNone) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::infinity();
  for (const test::MeasuredLayer& measured : test::measuredLayers(3, kBead)) {
    const CellAtlas atlas = atlasOf(measured);
    for (const Point3& point :
         {Point3(none, 0, 0), Point3(0, far, 0), Point3(0, 0, -far), Point3(1e300, 0, 0)})
      EXPECT_FALSE(atlas.look(point).newest);
  }
}

/// A search through all cells, by the words of the header.
TEST(CellAtlas, FindsWhatASearchThroughAllCellsFinds) {
  EXPECT_TRUE(rc::check([] {
    const auto layers = test::measuredLayers(4, kBead);
    const auto& measured = layers[*rc::gen::inRange<std::size_t>(0, layers.size())];
    const CellAtlas atlas = atlasOf(measured);
    const LayerCells& cells = *atlas.cellsOf(0);
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    for (int i = 0; i < 20; ++i) {
      const Point3 point = measured.place(random.below(4), random.uniform(-0.1, 1.1),
                                          random.uniform(-1.5, 1.5), random.uniform(-0.6, 0.6));
      bool is_inside = false;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const Point3 off = point - cells.middle[c];
        is_inside |= std::abs(off.dot(cells.tangent[c])) < 0.24 &&
                     std::abs(off.dot(cells.growth[c])) < 0.44 &&
                     std::abs(off.dot(cells.growth[c].cross(cells.tangent[c]))) < 0.59;
      }
      const auto found = atlas.look(point).newest;
      if (is_inside) RC_ASSERT(found.has_value());
      if (!found) continue;
      const Point3 off = point - cells.middle[found->cell];
      RC_ASSERT(std::abs(off.dot(cells.tangent[found->cell])) < 0.38);
      RC_ASSERT(std::abs(off.dot(cells.growth[found->cell])) < 0.46);
    }
  }));
}

}  // namespace
}  // namespace lamina
