// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "test_problems.hpp"

namespace lamina {
namespace {

std::string refusalOf(const DesignSpace& space) {
  try {
    validate(space);
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

TEST(DesignSpaceTest, RefusesVariablesThatTakeNoValueAndNamesThem) {
  EXPECT_EQ(refusalOf(mixedSpace()), "");
  EXPECT_NE(refusalOf({}).find("at least one"), std::string::npos);
  EXPECT_NE(refusalOf({continuous("d", 2.0, 1.0)}).find("variable d: bounds 2 to 1"), std::string::npos);
  EXPECT_NE(refusalOf({continuous("d", 0.0, NAN)}).find("variable d"), std::string::npos);
  EXPECT_NE(refusalOf({continuous("d", 0.0, 1.0), continuous("d", 0.0, 1.0)}).find("d stands twice"),
            std::string::npos);
  DesignSpace space = mixedSpace();
  space[1].high = 2.5;
  EXPECT_NE(refusalOf(space).find("walls: bounds 1 to 2.5"), std::string::npos);
  space = mixedSpace();
  space[2].levels = {0.3, 0.15};
  EXPECT_NE(refusalOf(space).find("layer_mm: level 0.15"), std::string::npos);
  space = mixedSpace();
  space[3].choices = {"average", "average"};
  EXPECT_NE(refusalOf(space).find("variable link"), std::string::npos);
}

TEST(DesignSpaceTest, NamesVariableValueAndWhatWasExpected) {
  const DesignSpace space = mixedSpace();
  const auto refusal = [&](const DesignPoint& point) -> std::string {
    try {
      requireWithin(space, point);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({0.3, 4.0, 0.15, 1.0}), "");
  EXPECT_EQ(refusal({0.2, 4.0, 0.15, 1.0}), "variable pitch_mm: 0.2; expected a number from 0.3 to 2.5");
  EXPECT_EQ(refusal({0.3, 1.5, 0.15, 1.0}), "variable walls: 1.5; expected a whole number from 1 to 4");
  EXPECT_EQ(refusal({0.3, 1.0, 0.25, 1.0}), "variable layer_mm: 0.25; expected one of 0.15, 0.2, 0.3");
  EXPECT_EQ(refusal({0.3, 1.0, 0.2, 2.0}), "variable link: 2; expected one of tangential, average");
  EXPECT_EQ(refusal({0.3}), "1 values for 4 variables");
}

TEST(DesignSpaceTest, BringsAnyPointToTheNearestAllowedOne) {
  const DesignSpace space = mixedSpace();
  EXPECT_EQ(nearestWithin(space, {9.0, 1.5, 0.26, 0.4}), (DesignPoint{2.5, 2.0, 0.3, 0.0}));
  EXPECT_EQ(nearestWithin(space, {-1.0, 9.0, 0.1, 1.6}), (DesignPoint{0.3, 4.0, 0.15, 1.0}));
}

TEST(DesignSpaceTest, RandomPointsLieWithinAndReachEveryChoice) {
  const DesignSpace space = mixedSpace();
  Random random(3);
  std::vector<int> walls(5);
  std::vector<int> links(2);
  for (int i = 0; i < 400; ++i) {
    const DesignPoint point = randomPoint(space, random);
    ASSERT_NO_THROW(requireWithin(space, point));
    ++walls[static_cast<std::size_t>(point[1])];
    ++links[static_cast<std::size_t>(point[3])];
  }
  for (int wall = 1; wall <= 4; ++wall) EXPECT_GT(walls[static_cast<std::size_t>(wall)], 60);
  EXPECT_GT(links[0], 150);
  EXPECT_GT(links[1], 150);
}

TEST(DesignSpaceTest, TextsReadBackToTheSameValue) {
  EXPECT_TRUE(rc::check([] {
    const DesignSpace space = mixedSpace();
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const DesignPoint point = randomPoint(space, random);
    for (std::size_t i = 0; i < space.size(); ++i)
      RC_ASSERT(valueOf(space[i], textOf(space[i], point[i])) == point[i]);
  }));
  EXPECT_EQ(textOf(mixedSpace()[3], 1.0), "average");
  EXPECT_EQ(textOf(mixedSpace()[0], 0.3), "0.3");
  EXPECT_THROW(valueOf(mixedSpace()[0], "0.3mm"), InvalidInput);
  EXPECT_THROW(valueOf(mixedSpace()[0], "7"), InvalidInput);
  EXPECT_THROW(valueOf(mixedSpace()[3], "radial"), InvalidInput);
}

}  // namespace
}  // namespace lamina
