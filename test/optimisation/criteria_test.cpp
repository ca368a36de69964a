// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/criteria.hpp"

namespace lamina {
namespace {

const std::vector<std::string> kNames = {"under_fill_mm2", "material_mm", "volume_error_mm3"};

TEST(CriteriaTest, UnderFillAndVolumeErrorWeighThreeUnlessSetOtherwise) {
  const auto usual = criteriaOf(kNames, {}, {});
  EXPECT_EQ(usual[0].weight, 3.0);
  EXPECT_EQ(usual[1].weight, 1.0);
  EXPECT_EQ(usual[2].weight, 3.0);
  const auto given = criteriaOf(kNames, {{"under_fill_mm2", "0.5"}}, {"material_mm"});
  EXPECT_EQ(given[0].weight, 0.5);
  EXPECT_EQ(given[2].weight, 3.0);
  EXPECT_EQ(given[1].sense, Sense::Maximise);
  EXPECT_EQ(given[0].sense, Sense::Minimise);
}

TEST(CriteriaTest, RefusesWhatIsNoResponseOrNoWeight) {
  EXPECT_THROW(criteriaOf(kNames, {{"mass_g", "1"}}, {}), InvalidConfig);
  EXPECT_THROW(criteriaOf(kNames, {}, {"mass_g"}), InvalidConfig);
  for (const char* weight : {"-1", "x", "", "inf", "1 "})
    EXPECT_THROW(criteriaOf(kNames, {{"material_mm", weight}}, {}), InvalidConfig) << weight;
  EXPECT_THROW(decisionMethodOf("topsi"), InvalidConfig);
}

TEST(CriteriaTest, WhatWeighsNothingMayBeMissing) {
  const std::vector<std::vector<double>> rows = {{1.0, NAN, 0.2}, {0.5, 4.0, 0.5}, {0.2, NAN, 1.0}};
  const auto criteria = criteriaOf(kNames, {{"material_mm", "0"}}, {});
  EXPECT_EQ(decide(criteria, rows, DecisionMethod::Linmap).chosen, 1U);
  try {
    decide(criteriaOf(kNames, {}, {}), rows, DecisionMethod::Linmap);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "alternative 1 has no material_mm; expected a number, or weight 0");
  }
}

TEST(CriteriaTest, MaximisedResponsesAreGoodWhereTheyAreGreat) {
  const std::vector<std::vector<double>> rows = {{1.0, 1.0, 1.0}, {1.0, 9.0, 1.0}};
  EXPECT_EQ(decide(criteriaOf(kNames, {}, {"material_mm"}), rows, decisionMethodOf("linmap")).chosen, 1U);
  EXPECT_EQ(decide(criteriaOf(kNames, {}, {"material_mm"}), rows, decisionMethodOf("topsis")).chosen, 1U);
  EXPECT_EQ(decide(criteriaOf(kNames, {}, {}), rows, decisionMethodOf("topsis")).chosen, 0U);
}

}  // namespace
}  // namespace lamina
