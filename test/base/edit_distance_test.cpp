// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/edit_distance.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lamina
