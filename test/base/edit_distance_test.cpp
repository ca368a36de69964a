// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/edit_distance.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lamina {
namespace {

TEST(EditDistance, SuggestsTheNearestName) {
  EXPECT_EQ(suggestionFor({"slice", "sweep", "check"}, "slcie"), "; did you mean 'slice'?");
  EXPECT_EQ(suggestionFor({"ab", "ac"}, "aa"), "; did you mean 'ab'?")
      << "the first of those that are as near";
  EXPECT_EQ(suggestionFor({}, "slice"), "");
  EXPECT_EQ(suggestionFor({"bridges.use", "fan.use"}, "bogus.key"), "") << "nothing is like it";
  EXPECT_EQ(suggestionFor({"box"}, "foo"), "");
  EXPECT_EQ(suggestionFor({"bead.width_mm"}, "width_mm"), "; did you mean 'bead.width_mm'?");
}

TEST(EditDistance, SuggestsNamesThatHoldTheGivenWordsFirst) {
  const std::vector<std::string> names{"layers.eight", "slicing.first_layer_height_mm",
                                       "slicing.layer_height_mm", "program.nozzle_temperature_c"};
  EXPECT_EQ(suggestionFor(names, "layer_height"), "; did you mean 'slicing.layer_height_mm'?")
      << "of two that hold it the nearer one, before one that is nearer still and does not";
  EXPECT_EQ(suggestionFor(names, "temperature"), "; did you mean 'program.nozzle_temperature_c'?");
  EXPECT_EQ(suggestionFor(names, "temp"), "") << "a part of a word is none";
  EXPECT_EQ(suggestionFor(names, ""), "");
}

}  // namespace
}  // namespace lamina
