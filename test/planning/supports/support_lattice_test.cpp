// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/support_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/planned_layers.hpp"

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

}  // namespace
}  // namespace lamina
