// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/placement.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lamina
