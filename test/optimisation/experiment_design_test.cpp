// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/experiment_design.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/fractional_factorial.hpp"
#include "optimisation/test_problems.hpp"

namespace lamina {
namespace {

template <class Call>
std::string experimentDesignRefusalOf(const Call& call) {
  try {
    call();
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "";
}

bool areDifferent(const std::vector<DesignPoint>& points) {
  return std::set<DesignPoint>(points.begin(), points.end()).size() == points.size();
}

double nearestPair(const std::vector<DesignPoint>& points) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double squares = 0.0;
      for (std::size_t k = 0; k < points[i].size(); ++k)
        squares += std::pow(points[i][k] - points[j][k], 2.0);
      nearest = std::min(nearest, std::sqrt(squares));
    }
  return nearest;
}

TEST(FullFactorialTest, CombinesLevelsWithTheLastVariableFastest) {
  const std::vector<DesignPoint> points = fullFactorial(mixedSpace(), {3, 2, 9, 9});
  ASSERT_EQ(points.size(), 3U * 2U * 3U * 2U);
  EXPECT_EQ(points[0], (DesignPoint{0.3, 1.0, 0.15, 0.0}));
  EXPECT_EQ(points[1], (DesignPoint{0.3, 1.0, 0.15, 1.0}));
  EXPECT_EQ(points[2], (DesignPoint{0.3, 1.0, 0.2, 0.0}));
  EXPECT_DOUBLE_EQ(points[12][0], 1.4);
  EXPECT_EQ(points.back(), (DesignPoint{2.5, 4.0, 0.3, 1.0}));
  EXPECT_TRUE(areDifferent(points));
  for (const DesignPoint& point : points) EXPECT_NO_THROW(requireWithin(mixedSpace(), point));
}

TEST(FullFactorialTest, TakesNoMoreLevelsThanThereAreWholeNumbers) {
  const DesignSpace space = {{"walls", VariableKind::Integer, 1.0, 4.0, {}, {}}};
  EXPECT_EQ(fullFactorial(space, {3}), (std::vector<DesignPoint>{{1.0}, {3.0}, {4.0}}));
  EXPECT_EQ(fullFactorial(space, {9}).size(), 4U);
}

TEST(FullFactorialTest, RefusesWhatCannotBeLaidOut) {
  EXPECT_EQ(experimentDesignRefusalOf([] { fullFactorial(unitSpace(1), {1}); }),
            "variable a: 1 levels; expected at least 2");
  EXPECT_NE(experimentDesignRefusalOf([] {
              fullFactorial(unitSpace(7), std::vector<int>(7, 10));
            }).find("more than 1000000 points"),
            std::string::npos);
}

TEST(FractionalFactorialTest, FourthVariableFollowsFromThree) {
  const FractionalFactorial design = fractionalFactorial(unitSpace(4), "d=abc");
  EXPECT_EQ(design.resolution, 4);
  EXPECT_EQ(design.defining_words, (std::vector<std::string>{"abcd"}));
  ASSERT_EQ(design.points.size(), 8U);
  EXPECT_TRUE(areDifferent(design.points));
  EXPECT_EQ(design.points[0], (DesignPoint{-1.0, -1.0, -1.0, -1.0}));
  EXPECT_EQ(design.points[1], (DesignPoint{-1.0, -1.0, 1.0, 1.0}));
  for (const DesignPoint& point : design.points) EXPECT_EQ(point[3], point[0] * point[1] * point[2]);
  for (const DesignPoint& point : fractionalFactorial(unitSpace(4), "d=-abc").points)
    EXPECT_EQ(point[3], -point[0] * point[1] * point[2]);
}

TEST(FractionalFactorialTest, ReportsTheResolutionOfTheTabulatedDesigns) {
  // Montgomery, Design and Analysis of Experiments, Table 8.14.
  EXPECT_EQ(fractionalFactorial(unitSpace(3), "c=ab").resolution, 3);
  EXPECT_EQ(fractionalFactorial(unitSpace(5), "e=abcd").resolution, 5);
  EXPECT_EQ(fractionalFactorial(unitSpace(5), "d=ab, e=ac").resolution, 3);
  EXPECT_EQ(fractionalFactorial(unitSpace(6), "e=abc f=bcd").resolution, 4);
  EXPECT_EQ(fractionalFactorial(unitSpace(7), "d=ab,e=ac,f=bc,g=abc").resolution, 3);
  EXPECT_EQ(fractionalFactorial(unitSpace(7), "d=ab,e=ac,f=bc,g=abc").defining_words.size(), 15U);
  EXPECT_EQ(fractionalFactorial(unitSpace(8), "e=bcd,f=acd,g=abc,h=abd").resolution, 4);
  EXPECT_EQ(fractionalFactorial(unitSpace(3), "").resolution, 0);
}

TEST(FractionalFactorialTest, ColumnsAreBalancedAndUncorrelated) {
  const std::vector<DesignPoint> points = fractionalFactorial(unitSpace(6), "e=abc,f=bcd").points;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (const DesignPoint& point : points) sum += i == j ? point[i] : point[i] * point[j];
      EXPECT_EQ(sum, 0.0) << i << " " << j;
    }
}

TEST(FractionalFactorialTest, RefusesMixedLevelsAndGeneratorsThatMakeNoSense) {
  DesignSpace mixed = unitSpace(3);
  mixed[1] = {"layer_mm", VariableKind::Levels, 0.0, 0.0, {0.15, 0.2, 0.3}, {}};
  EXPECT_NE(
      experimentDesignRefusalOf([&] { fractionalFactorial(mixed, "c=ab"); }).find("layer_mm has 3 levels"),
      std::string::npos);
  const auto refusal = [](const std::string& generators) {
    return experimentDesignRefusalOf([&] { fractionalFactorial(unitSpace(5), generators); });
  };
  EXPECT_NE(refusal("d").find("generator 'd': expected a letter"), std::string::npos);
  EXPECT_NE(refusal("d=xy").find("'x' is no variable; expected a to e"), std::string::npos);
  EXPECT_NE(refusal("d=aab").find("'a' stands twice"), std::string::npos);
  EXPECT_NE(refusal("d=ab,d=ac").find("variable d has a generator already"), std::string::npos);
  EXPECT_NE(refusal("d=ab,e=ad").find("refers to a variable that has a generator itself"), std::string::npos);
  EXPECT_NE(refusal("d=ab,e=ab").find("de is the same in every point"), std::string::npos);
  EXPECT_NE(refusal("e=a").find("ae is the same in every point"), std::string::npos);
}

TEST(LatinHypercubeTest, EachPartOfEachRangeIsSampledOnce) {
  EXPECT_TRUE(rc::check("Latin hypercube", [] {
    const auto count = *rc::gen::inRange<std::size_t>(2, 40);
    const auto dimensions = *rc::gen::inRange<std::size_t>(1, 5);
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const std::vector<DesignPoint> points = latinHypercube(unitSpace(dimensions), count, seed);
    RC_ASSERT(points.size() == count);
    RC_ASSERT(areDifferent(points));
    for (std::size_t k = 0; k < dimensions; ++k) {
      std::set<long> parts;
      for (const DesignPoint& point : points)
        parts.insert(std::lround(std::floor((point[k] + 1.0) / 2.0 * static_cast<double>(count))));
      RC_ASSERT(parts.size() == count);
      RC_ASSERT(*parts.begin() == 0 && *parts.rbegin() == static_cast<long>(count) - 1);
    }
  }));
}

TEST(LatinHypercubeTest, ValuesOfDiscreteVariablesComeEquallyOften) {
  const std::vector<DesignPoint> points = latinHypercube(mixedSpace(), 24, 5);
  EXPECT_TRUE(areDifferent(points));
  const auto times = [&](std::size_t variable, double value) {
    return std::count_if(points.begin(), points.end(),
                         [&](const DesignPoint& point) { return point[variable] == value; });
  };
  for (const double walls : {1.0, 2.0, 3.0, 4.0}) EXPECT_EQ(times(1, walls), 6);
  for (const double layer : {0.15, 0.2, 0.3}) EXPECT_EQ(times(2, layer), 8);
  for (const double link : {0.0, 1.0}) EXPECT_EQ(times(3, link), 12);
  for (const DesignPoint& point : points) EXPECT_NO_THROW(requireWithin(mixedSpace(), point));
}

TEST(LatinHypercubeTest, SpreadsItsPointsFartherThanRandomOnes) {
  double spread = 0.0;
  double random = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    spread += nearestPair(latinHypercube(unitSpace(2), 16, seed));
    Random generator(seed);
    std::vector<DesignPoint> points;
    for (int i = 0; i < 16; ++i) points.push_back(randomPoint(unitSpace(2), generator));
    random += nearestPair(points);
  }
  // The best one known of 16 points in the plane: nearest distance sqrt(17) of 16 parts [VanDam2007].
  EXPECT_GT(spread / 5.0, 0.75 * std::sqrt(17.0) * 2.0 / 16.0);
  EXPECT_GT(spread, 3.0 * random);
}

TEST(LatinHypercubeTest, SameSeedSamePoints) {
  EXPECT_EQ(latinHypercube(mixedSpace(), 12, 7), latinHypercube(mixedSpace(), 12, 7));
  EXPECT_NE(latinHypercube(mixedSpace(), 12, 7), latinHypercube(mixedSpace(), 12, 8));
}

TEST(LatinHypercubeTest, TakesEveryPointOfASmallSpaceAndRefusesMore) {
  const DesignSpace space = {{"walls", VariableKind::Integer, 1.0, 2.0, {}, {}},
                             {"link", VariableKind::Categorical, 0.0, 0.0, {}, {"a", "b", "c"}}};
  EXPECT_EQ(latinHypercube(space, 6, 1).size(), 6U);
  EXPECT_TRUE(areDifferent(latinHypercube(space, 6, 1)));
  EXPECT_NE(
      experimentDesignRefusalOf([&] { latinHypercube(space, 7, 1); }).find("Latin hypercube of 7 points"),
      std::string::npos);
}

TEST(ExperimentDesignTest, SettingsChooseTheDesign) {
  ExperimentDesignSettings settings;
  EXPECT_EQ(designExperiment(unitSpace(2), settings, 1).size(), 20U);
  settings.samples = 7;
  EXPECT_EQ(designExperiment(unitSpace(2), settings, 1).size(), 7U);
  settings.kind = DesignKind::FullFactorial;
  EXPECT_EQ(designExperiment(unitSpace(3), settings, 1).size(), 8U);
  settings.levels = "2, 4,3";
  EXPECT_EQ(designExperiment(unitSpace(3), settings, 1).size(), 24U);
  for (const char* levels : {"", "1", "2,3", "2,x,3", "2.5"}) {
    settings.levels = levels;
    EXPECT_NE(experimentDesignRefusalOf([&] {
                designExperiment(unitSpace(3), settings, 1);
              }).find("surrogate.levels"),
              std::string::npos)
        << levels;
  }
  settings.kind = DesignKind::FractionalFactorial;
  settings.generators = "c=ab";
  EXPECT_EQ(designExperiment(unitSpace(3), settings, 1).size(), 4U);
}

}  // namespace
}  // namespace lamina
