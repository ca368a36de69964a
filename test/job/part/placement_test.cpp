// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/placement.hpp"

#include <gtest/gtest.h>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

const Box3 kBox{{-1.0, 4.0, -7.0}, {3.0, 10.0, 5.0}};

TEST(Placement, CentrePutsTheMiddleOverTheBedAndTheBottomOnIt) {
  const Eigen::Isometry3d bed_from_part = placePart(kBox, {100.0, 80.0}, Placement::Centre);
  const Point3 bottom_middle = bed_from_part * Point3(1.0, 7.0, -7.0);
  EXPECT_TRUE(bottom_middle.isApprox(Point3(100.0, 80.0, 0.0)));
  EXPECT_TRUE(bed_from_part.linear().isIdentity());
}

TEST(Placement, AsIsKeepsTheCoordinatesOfTheFile) {
  EXPECT_TRUE(placePart(kBox, {100.0, 80.0}, Placement::AsIs).isApprox(Eigen::Isometry3d::Identity()));
}

TEST(Placement, OfAToolpathPutsTheUndersidesOfItsLowestBeadsOnTheBed) {
  Path bead = test::straightPath({10, 20, 5}, {30, 20, 5});
  bead.bead = Bead{1.0, 0.5};
  Path travel = test::straightPath({30, 20, 5}, {500, 500, 0});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  const Point2 middle = boundingBox(space).centre().head<2>();
  const Eigen::Isometry3d bed_from_part = placeDeposition({"bead", {{5.0, 0.5, {bead, travel}}}}, space);
  const Point3 under_middle = bed_from_part * Point3(20, 20, 4.5);
  EXPECT_TRUE(under_middle.isApprox(Point3(middle.x(), middle.y(), 0.0)));
}

}  // namespace
}  // namespace lamina
