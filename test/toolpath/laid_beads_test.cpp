// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/laid_beads.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

// A square of 4 x 10 mm, a travel of 0.2 mm, and a line of 10 mm: 50 mm of beads.
const LaidBeads& squareAndLine() {
  static const LaidBeads kBeads(test::twoLayers());
  return kBeads;
}

Eigen::Isometry3d nozzleAt(const Point3& tip, double lean_rad = 0.0) {
  Eigen::Isometry3d nozzle = Eigen::Isometry3d::Identity();
  nozzle.translation() = tip;
  nozzle.linear() = (Eigen::AngleAxisd(lean_rad, Point3::UnitX()) * nozzleDown()).toRotationMatrix();
  return nozzle;
}

LaidSearch searchFrom(double from_mm) {
  LaidSearch search;
  search.reported_mm = from_mm;
  search.tolerance_mm = 0.15;
  return search;
}

TEST(LaidBeads, MeasuresBeadsAndNoTravels) {
  EXPECT_DOUBLE_EQ(squareAndLine().total(), 50.0);
  EXPECT_DOUBLE_EQ(squareAndLine().before({0, 0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(squareAndLine().before({0, 0, 3}), 30.0);
  EXPECT_DOUBLE_EQ(squareAndLine().before({0, 1, 1}), 40.0);
  EXPECT_DOUBLE_EQ(squareAndLine().before({1, 0, 1}), 50.0);
  EXPECT_THROW(squareAndLine().before({1, 0, 2}), InvalidInput);
  EXPECT_THROW(squareAndLine().before({2, 0, 0}), InvalidInput);
  EXPECT_EQ(LaidBeads(Toolpath()).total(), 0.0);
}

TEST(LaidBeads, MeasuresTheirVolume) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[1].paths[0].bead = Bead{0.8, 0.2};
  const LaidBeads beads(toolpath);
  const double wall_mm3 = 40.0 * crossSection({0.4, 0.2});
  EXPECT_NEAR(beads.volume(20.0), 0.5 * wall_mm3, 1e-9);
  EXPECT_NEAR(beads.volume(43.0), wall_mm3 + 3.0 * crossSection({0.8, 0.2}), 1e-9);
  EXPECT_NEAR(beads.volume(60.0), wall_mm3 + 10.0 * crossSection({0.8, 0.2}), 1e-9);
}

TEST(LaidBeads, KnowsTheBeadThatGoesOn) {
  EXPECT_DOUBLE_EQ(squareAndLine().beadStart(0.0), 0.0);
  EXPECT_DOUBLE_EQ(squareAndLine().beadStart(35.0), 0.0);
  EXPECT_DOUBLE_EQ(squareAndLine().beadStart(40.0), 40.0) << "the next one";
  EXPECT_DOUBLE_EQ(squareAndLine().beadStart(45.0), 40.0);
  EXPECT_DOUBLE_EQ(squareAndLine().beadStart(50.0), 50.0);
  EXPECT_EQ(squareAndLine().headingFor(12.0), (WaypointIndex{0, 0, 2}));
  EXPECT_EQ(squareAndLine().headingFor(35.0), (WaypointIndex{0, 0, 0})) << "the return of a closed path";
  EXPECT_EQ(squareAndLine().headingFor(40.0), (WaypointIndex{1, 0, 1}));
  EXPECT_EQ(squareAndLine().headingFor(50.0), (WaypointIndex{1, 0, 1}));
}

TEST(LaidBeads, FindsWhereTheNozzleStands) {
  const auto find = [](const Point3& tip, double from_mm) {
    return squareAndLine().find(nozzleAt(tip), searchFrom(from_mm));
  };
  EXPECT_NEAR(find({10, 4, 0.2}, 0.0).value(), 14.0, 1e-9);
  EXPECT_NEAR(find({10.1, 4, 0.2}, 0.0).value(), 14.0, 1e-9) << "beside it";
  EXPECT_FALSE(find({10.2, 4, 0.2}, 0.0));
  EXPECT_FALSE(find({10, 4, 0.2}, 20.0)) << "that lies before";
  // Lines above each other.
  EXPECT_NEAR(find({4, 0, 0.25}, 0.0).value(), 4.0, 1e-9);
  EXPECT_NEAR(find({4, 0, 0.39}, 0.0).value(), 44.0, 1e-9);
  // On the travel, with the square laid.
  EXPECT_NEAR(find({0, 0, 0.3}, 30.0).value(), 40.0, 1e-9);
  EXPECT_FALSE(squareAndLine().find(nozzleAt({10, 4, 0.2}, 0.06), searchFrom(0.0))) << "another tool axis";
  EXPECT_TRUE(squareAndLine().find(nozzleAt({10, 4, 0.2}, 0.04), searchFrom(0.0)));
}

TEST(LaidBeads, FindNoPlaceWhereTwoAreAsNear) {
  // The square begins and ends there.
  EXPECT_FALSE(squareAndLine().find(nozzleAt({0, 0, 0.2}), searchFrom(0.0)));
  EXPECT_NEAR(squareAndLine().find(nozzleAt({0, 0, 0.2}), searchFrom(20.0)).value(), 40.0, 1e-9);
  // Between two layers: 0.11 mm above one and 0.09 mm below the other.
  EXPECT_FALSE(squareAndLine().find(nozzleAt({4, 0, 0.31}), searchFrom(0.0)));
}

TEST(LaidBeads, FindNothingBeyondTheSearch) {
  LaidSearch search = searchFrom(10.0);
  search.ahead_mm = 3.0;
  EXPECT_FALSE(squareAndLine().find(nozzleAt({10, 4, 0.2}), search)) << "after 14 mm";
  search.ahead_mm = 5.0;
  EXPECT_NEAR(squareAndLine().find(nozzleAt({10, 4, 0.2}), search).value(), 14.0, 1e-9);
  // A tool that was lifted from a layer to a later one.
  search.ahead_mm = 100.0;
  EXPECT_NEAR(squareAndLine().find(nozzleAt({4, 0, 0.4}), search).value(), 44.0, 1e-9);
  search.most_rise_mm = 0.15;
  EXPECT_FALSE(squareAndLine().find(nozzleAt({4, 0, 0.4}), search));
}

}  // namespace
}  // namespace lamina
