// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/sliding_mode.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(SlidingMode, PolesOfTheSourcesGainsAreThoseOfItsDesign) {
  const auto found = poles({});
  EXPECT_NEAR(found[0].real(), -46.0, 0.05);
  EXPECT_NEAR(found[0].imag(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(found[1]), 13.143, 0.0005);
  EXPECT_NEAR(-found[1].real() / std::abs(found[1]), 0.700, 0.0005);
  EXPECT_NEAR(std::abs(found[1] - std::conj(found[2])), 0.0, 1e-9);
}

TEST(SlidingMode, SurfaceWeighsTheErrorAndItsIntegrals) {
  SlidingModeGains gains{2.0, 3.0, 5.0, 10.0, 100.0};
  const TrackingError error{CrankAngles::Constant(1.0), CrankAngles::Constant(10.0),
                            CrankAngles::Constant(0.1), CrankAngles::Constant(0.01)};
  EXPECT_NEAR(slidingSurface(gains, error)[0], 10.0 + 2.0 + 0.3 + 0.05, 1e-12);
  EXPECT_NEAR(askedAccelerations(gains, error)[5], 20.0 + 3.0 + 0.5 + 10.0 * 0.1235, 1e-12);
  gains.boundary = 1.0;
  EXPECT_NEAR(askedAccelerations(gains, error)[5], 20.0 + 3.0 + 0.5 + 10.0, 1e-12) << "saturated";
}

TEST(SlidingMode, GainsUnderWhichErrorsGrowAreRefused) {
  SlidingModeGains gains;
  gains.k3 = gains.k1 * gains.k2 * 1.01;  // Routh's bound
  EXPECT_THROW(requireStable(gains), InvalidConfig);
  gains.k3 = gains.k1 * gains.k2 * 0.99;
  EXPECT_NO_THROW(requireStable(gains));
}

}  // namespace
}  // namespace lamina
