// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/available_memory.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lamina {
namespace {

TEST(AvailableMemory, SomeIsFreeAndThePeakCoversWhatIsHeld) {
  constexpr std::size_t kHeld = 50'000'000;
  EXPECT_GT(availableMemory(), 0.0);
  const std::vector<char> held(kHeld, 'x');
  EXPECT_GE(peakMemory(), static_cast<double>(held.size()));
  EXPECT_LT(peakMemory(), 1e12);
}

}  // namespace
}  // namespace lamina
