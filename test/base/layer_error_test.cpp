// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/layer_error.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace lamina {
namespace {

Failure rethrown(const std::function<void()>& act) {
  try {
    try {
      act();
    } catch (...) {
      rethrowAt("layer 3");
    }
  } catch (...) {
    return currentFailure();
  }
  return {};
}

TEST(ErrorPlace, NamesLayerAndIsland) {
  EXPECT_EQ(layerPlace(12, 2.4), "layer 12 at 2.4 mm");
  EXPECT_EQ(islandPlace(0, 0.1 + 0.2, 3), "layer 0 at 0.3 mm, island 3");
}

TEST(RethrowAt, KeepsTheKindOfEveryErrorAndNamesThePlace) {
  for (int code = 1; code < 50; ++code) {
    const Failure thrown{static_cast<ErrorCode>(code), "too thin"};
    if (std::string(toString(thrown.code)) == "Unknown") continue;
    const Failure failure = rethrown([&] { throwFailure(thrown); });
    EXPECT_EQ(failure.code, thrown.code);
    EXPECT_EQ(failure.message, "layer 3: too thin") << toString(thrown.code);
  }
}

TEST(RethrowAt, ThrowsAnErrorThatIsCaughtByItsType) {
  const auto rethrow = [] {
    try {
      throw InvalidMesh("open");
    } catch (...) {
      rethrowAt("layer 3");
    }
  };
  EXPECT_THROW(rethrow(), InvalidMesh);
}

TEST(RethrowAt, LeavesACancellationAsItIs) {
  EXPECT_EQ(rethrown([] { throw Cancelled("stopped"); }).message, "stopped");
}

TEST(RethrowAt, TakesOtherExceptionsForInternalErrors) {
  const Failure failure = rethrown([] { throw std::out_of_range("index 7"); });
  EXPECT_EQ(failure.code, ErrorCode::Internal);
  EXPECT_EQ(failure.message, "layer 3: index 7");
}

}  // namespace
}  // namespace lamina
