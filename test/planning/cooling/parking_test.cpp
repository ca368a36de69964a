// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/parking.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

const Box3 kPart{Point3(0.0, 0.0, 0.0), Point3(40.0, 30.0, 20.0)};
const double kSine45 = std::sqrt(0.5);

void expectPlace(const Point3& actual, const Point3& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-12) << actual.transpose() << ", not " << expected.transpose();
}

TEST(ParkingPlace, IsBesideAPartOfLevelLayers) {
  const Point3 here(10.0, 20.0, 5.0);
  expectPlace(parkingPlace(here, kPart, ParkPlace::Outside, Point3::UnitZ()), {-5.0, 20.0, 5.0});
  expectPlace(parkingPlace(here, kPart, ParkPlace::Corner, Point3::UnitZ()), {0.0, 0.0, 5.0});
  expectPlace(parkingPlace(here, kPart, ParkPlace::Stay, Point3::UnitZ()), here);
}

// The corner would be 20 mm / sqrt(2) above or below the layer along its normal.
TEST(ParkingPlace, IsInTheLayerWhereItLeansAlongTheCornersSide) {
  const Point3 here(10.0, 20.0, 5.0);
  for (const double lean : {-kSine45, kSine45})
    expectPlace(parkingPlace(here, kPart, ParkPlace::Corner, {0.0, lean, kSine45}), {0.0, 20.0, 5.0});
}

TEST(ParkingPlace, IsNeverInWhatIsBelowTheLayer) {
  const Point3 here(10.0, 20.0, 5.0);
  // 15 mm along -x lead into the layers below those at 45 deg, unless the nozzle rises by as much.
  expectPlace(parkingPlace(here, kPart, ParkPlace::Outside, {kSine45, 0.0, kSine45}), {-5.0, 20.0, 20.0});
  expectPlace(parkingPlace(here, kPart, ParkPlace::Outside, {-kSine45, 0.0, kSine45}), {-5.0, 20.0, 5.0});
}

}  // namespace
}  // namespace lamina
