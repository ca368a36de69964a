// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/front_archive.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace lamina {
namespace {

using Costs = std::vector<double>;

TEST(FrontArchive, DropsWhatALaterMemberDominates) {
  FrontArchive archive;
  archive.add(0, {2.0, 2.0});
  archive.add(1, {3.0, 1.0});
  archive.add(2, {3.0, 2.0});
  EXPECT_EQ(archive.members(), (std::vector<std::size_t>{0, 1}));
  archive.add(3, {1.0, 2.0});
  EXPECT_EQ(archive.members(), (std::vector<std::size_t>{1, 3}));
}

TEST(FrontArchive, KeepsEqualsAndNothingBesideALowerSingleCost) {
  FrontArchive archive;
  for (const std::size_t member : {4, 5}) archive.add(member, {1.0});
  EXPECT_EQ(archive.members(), (std::vector<std::size_t>{4, 5}));
  archive.add(6, {0.5});
  EXPECT_EQ(archive.members(), (std::vector<std::size_t>{6}));
}

RC_GTEST_PROP(FrontArchive, HoldsWhatNoOtherDominates, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 5);
  const auto cost = rc::gen::map(rc::gen::inRange(0, 6), [](int value) { return 0.5 * value; });
  const auto all = *rc::gen::container<std::vector<Costs>>(rc::gen::container<Costs>(count, cost));
  FrontArchive archive;
  for (std::size_t i = 0; i < all.size(); ++i) archive.add(i, all[i]);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto dominatesIt = [&](const Costs& other) {
      const auto isNoHigher = [](double a, double b) { return a <= b; };
      return other != all[i] && std::equal(other.begin(), other.end(), all[i].begin(), isNoHigher);
    };
    if (std::none_of(all.begin(), all.end(), dominatesIt)) expected.push_back(i);
  }
  std::vector<std::size_t> members = archive.members();
  std::sort(members.begin(), members.end());
  RC_ASSERT(members == expected);
}

}  // namespace
}  // namespace lamina
