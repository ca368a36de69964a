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
  EXPECT_EQ(pathPlace(4, 1.0, 7), "layer 4 at 1 mm, path 7");
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

/// An error with a number besides its message.
struct NumberedError : InvalidMesh, RichError {
  NumberedError(const std::string& message, int its_number) : InvalidMesh(message), number(its_number) {}
  [[noreturn]] void throwAt(const std::string& place) const override {
    throw NumberedError(place + ": " + what(), number);
  }

  int number;
};

TEST(RethrowAt, KeepsWhatAnErrorCarriesBesides) {
  try {
    try {
      throw NumberedError("open", 7);
    } catch (...) {
      rethrowAt("layer 3");
    }
  } catch (const NumberedError& error) {
    EXPECT_EQ(error.number, 7);
    EXPECT_STREQ(error.what(), "layer 3: open");
  }
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
