// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/straight_beads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "lamina/base/random.hpp"
#include "lamina/control/cell_atlas.hpp"
#include "support/control_layers.hpp"
#include "support/measured_layers.hpp"

namespace lamina {
namespace {

/// Of cells with a reach of 1.5 layers.
struct Sheet {
  LayerCells cells;
  StationIndex index{cells, 1.5};
  StraightBeads beads{cells, index};

  std::uint32_t at(const Point3& point) const {
    const Point3 place = index.placeOf(point);
    return beads.cellAt(index.stations().cellAt(place), place);
  }
};

std::vector<double> pitched(double pitch, int beads) {
  std::vector<double> y;
  for (int i = 0; i < beads; ++i) y.push_back(pitch * i);
  return y;
}

/// Beads of 20 mm by 3 mm in cells of 0.5 mm, side by side or overlapping by a fifth: cell and bead follow
/// from a division, and nearly all points are answered.
TEST(StraightBeads, DivideTheWayAlongTheNearestBead) {
  for (const double pitch : {3.0, 2.4}) {
    const Sheet sheet{test::straightBeads(pitched(pitch, 12), 20.0, 0.5)};
    Random random(11);
    int unsure = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = random.uniform(0.0, 20.0);
      const double y = random.uniform(-1.5, 11.0 * pitch + 1.5);
      const std::uint32_t cell = sheet.at({x, y, 1.5});
      unsure += cell == StraightBeads::kUnsure ? 1 : 0;
      if (cell == StraightBeads::kUnsure) continue;
      const double bead = std::clamp(std::round(y / pitch), 0.0, 11.0);
      ASSERT_EQ(cell, 40 * static_cast<std::uint32_t>(bead) + static_cast<std::uint32_t>(x / 0.5))
          << x << " " << y;
    }
    EXPECT_LE(unsure, 200) << pitch;  // 1 %
  }
}

TEST(StraightBeads, KnowThatNothingLiesBetweenOrBesideBeads) {
  const Sheet sheet{test::straightBeads({0.0, 5.0}, 20.0, 0.5)};
  EXPECT_EQ(sheet.at({10.2, 2.5, 1.5}), StraightBeads::kNone);
  EXPECT_EQ(sheet.at({10.2, 90.0, 1.5}), StraightBeads::kNone);
  EXPECT_EQ(sheet.at({10.2, 1.2, 1.5}), 20U);
}

/// Of 0.51 widths (1.53 mm), of the middle between two cells (10 mm) and of two beads (1.5 mm).
TEST(StraightBeads, LeaveToASearchWhatRoundingMayDecide) {
  const Sheet sheet{test::straightBeads({0.0, 3.0, 8.0}, 20.0, 0.5)};
  EXPECT_EQ(sheet.at({10.2, 4.53, 1.5}), StraightBeads::kUnsure);
  EXPECT_EQ(sheet.at({10.0, 0.2, 1.5}), StraightBeads::kUnsure);
  EXPECT_EQ(sheet.at({10.2, 1.5, 1.5}), StraightBeads::kUnsure);
  EXPECT_EQ(sheet.at({20.2, 0.0, 1.5}), StraightBeads::kUnsure);  // beyond the end, within reach
}

void expectNoBitChanged(const CellAtlas& atlas, const std::vector<Point3>& points, const std::string& name) {
  const auto sights = atlas.newestAt(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto one = atlas.newestAt(points[i]);
    ASSERT_EQ(sights[i].has_value(), one.has_value()) << name << " " << i;
    if (!one) continue;
    ASSERT_EQ(sights[i]->cell, one->cell) << name << " " << i;
    ASSERT_EQ(sights[i]->error_mm, one->error_mm);
    ASSERT_EQ(sights[i]->off_mm, one->off_mm);
    ASSERT_EQ(sights[i]->across_mm, one->across_mm);
    ASSERT_EQ(sights[i]->across_share, one->across_share);
  }
}

/// The same cells, errors and places to the last bit as one look-up after the other, whose cells are
/// searched: layers of each kind, whole and half deposited, and points off them.
TEST(StraightBeads, ChangeNoBitOfWhatASearchFinds) {
  constexpr Bead kBead{1.2, 0.3};
  for (const test::MeasuredLayer& measured : test::measuredLayers(12, kBead)) {
    CellAtlas atlas;
    atlas.add(std::make_shared<const LayerCells>(test::cellsOf(measured)));
    Random random(12);
    for (const double share : {1.0, 0.5}) {
      const auto all = static_cast<double>(atlas.cellsOf(0)->size());
      atlas.setDeposited(0, static_cast<std::size_t>(share * all));
      std::vector<Point3> points;
      for (int i = 0; i < 20000; ++i)
        points.push_back(measured.place(random.below(measured.beads), random.uniform(-0.05, 1.05),
                                        random.uniform(-1.0, 1.0), random.uniform(-0.5, 0.5)));
      expectNoBitChanged(atlas, points, measured.name);
    }
  }
}

/// Contours with corners, and beads that cross, touch and follow one another by their numbers.
TEST(StraightBeads, ChangeNoBitAmongCrossedAndBentBeads) {
  Random random(13);
  for (int layout = 0; layout < 30; ++layout) {
    ToolpathLayer layer{1.0, 1.0, {}};
    for (int bead = 0; bead < 8; ++bead) {
      Path path = test::measuredBead({random.uniform(0.6, 2.0), 1.0});
      path.is_closed = bead % 4 == 3;
      const int corners = path.is_closed ? 4 : 2 + bead % 3;
      for (int i = 0; i < corners; ++i)
        path.points.push_back({10.0 + random.uniform(0.0, 20.0), random.uniform(0.0, 20.0), 1.0});
      layer.paths.push_back(path);
      // One beside it that begins where it ends, as in a zigzag.
      const Point3 beside(0.0, 0.9, 0.0);
      path.is_closed = false;
      path.points = {path.points[1] + beside, path.points[0] + beside};
      layer.paths.push_back(path);
    }
    CellAtlas atlas;
    atlas.add(std::make_shared<const LayerCells>(layerCells(layer, 0, 0.5)));
    std::vector<Point3> points;
    for (int i = 0; i < 5000; ++i)
      points.push_back(
          {random.uniform(8.0, 32.0), random.uniform(-2.0, 22.0), 1.0 + random.uniform(-2.0, 2.0)});
    expectNoBitChanged(atlas, points, "layout " + std::to_string(layout));
  }
}

}  // namespace
}  // namespace lamina
