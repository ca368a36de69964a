// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/study.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

TEST(StudyTest, OfAnotherPartKeepsAllButWhatWasPublishedOfItsOwn) {
  Study study;
  study.name = "Box";
  study.search = {{"nsga2.seed", "7"}};
  study.slice = SliceMeasure();
  study.slice->part = "box";
  study.slice->parameters = {{"x_mm", "20"}};
  study.slice->settings = {{"walls.count", "0"}};
  study.published_source = "somewhere";
  study.published = {{"optimum", {{"material_mm", "1"}}}};
  const Study other = ofPart(study, "pawn.stl");
  EXPECT_EQ(other.name, "Box, for pawn.stl");
  EXPECT_EQ(other.slice->part, "pawn.stl");
  EXPECT_TRUE(other.slice->parameters.empty());
  EXPECT_EQ(other.slice->settings.size(), 1U);
  EXPECT_EQ(other.search.size(), 1U);
  EXPECT_TRUE(other.published.empty());
  EXPECT_EQ(other.published_source, "");
}

TEST(StudyTest, OfCommandsHasNoPartToReplace) {
  Study study;
  study.name = "Scaffolds";
  EXPECT_THROW(ofPart(study, "pawn.stl"), InvalidConfig);
}

}  // namespace
}  // namespace lamina
