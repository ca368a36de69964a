// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/equivalent_modulus.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

// [Vega2023, eq. 6 and table 15]: specimens 5 mm wide over a span of 32 mm, bent by 1 mm.
TEST(EquivalentModulus, OfBendingIsThatOfThePublishedSpecimens) {
  EXPECT_NEAR(bendingModulus(18.64, 32.0, 1.0, {5.0, 2.1}), 3297.68, 0.005);
  EXPECT_NEAR(bendingModulus(13.49, 32.0, 1.0, {5.0, 2.1}), 2386.57, 0.005);
  EXPECT_NEAR(bendingModulus(9.95, 32.0, 1.0, {5.0, 1.95}), 2198.6, 0.05);
}

TEST(EquivalentModulus, OfCompressionIsStressOverStrain) {
  EXPECT_NEAR(compressionModulus(6949.8, 9.0, 81.0, 0.2), 3861.0, 1e-9);
}

}  // namespace
}  // namespace lamina
