// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/outline_links.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

/// Runs up from the lower side of a 10 x 10 square at these x, to y = 5.
std::vector<RunOnOutlines> runsUpFrom(const std::vector<double>& x) {
  std::vector<RunOnOutlines> runs;
  for (const double at : x) runs.push_back({{{at, 0}, {at, 5}}, OutlinePoint{0, 0, at}, std::nullopt});
  return runs;
}

const std::vector<Polygon> kOutlineLinksSquare = {test::rectangle(0, 0, 10, 10)};

TEST(OutlineLinks, JoinEndsThatFollowEachOtherAlongTheOutline) {
  const std::vector<Polyline> joined = joinAlongOutlines(runsUpFrom({2, 3}), kOutlineLinksSquare, 1.5);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0], (Polyline{{2, 5}, {2, 0}, {3, 0}, {3, 5}}));
}

TEST(OutlineLinks, GoRoundTheCornersOfTheOutline) {
  std::vector<RunOnOutlines> runs = runsUpFrom({9});
  runs.push_back({{{10, 1}, {5, 1}}, OutlinePoint{0, 1, 1.0}, std::nullopt});
  const std::vector<Polyline> joined = joinAlongOutlines(runs, kOutlineLinksSquare, 2.5);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0], (Polyline{{9, 5}, {9, 0}, {10, 0}, {10, 1}, {5, 1}}));
}

TEST(OutlineLinks, GoOnFromTheLastPointOfAnOutlineToItsFirst) {
  std::vector<RunOnOutlines> runs = runsUpFrom({1});
  runs.push_back({{{0, 1}, {5, 1}}, OutlinePoint{0, 3, 9.0}, std::nullopt});
  const std::vector<Polyline> joined = joinAlongOutlines(runs, kOutlineLinksSquare, 2.5);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0], (Polyline{{1, 5}, {1, 0}, {0, 0}, {0, 1}, {5, 1}}));
}

TEST(OutlineLinks, AreNoLongerThanAllowed) {
  EXPECT_EQ(joinAlongOutlines(runsUpFrom({2, 4}), kOutlineLinksSquare, 1.5).size(), 2U);
}

TEST(OutlineLinks, PassNoOtherEnd) {
  // The middle one joins its nearer neighbour; the third is not reached past it.
  const std::vector<Polyline> joined = joinAlongOutlines(runsUpFrom({2, 3, 4.5}), kOutlineLinksSquare, 5.0);
  EXPECT_EQ(joined.size(), 2U);
}

TEST(OutlineLinks, JoinMoreIfEveryOtherIsMade) {
  const std::vector<RunOnOutlines> runs = runsUpFrom({2, 4, 5, 7});
  EXPECT_EQ(joinAlongOutlines(runs, kOutlineLinksSquare, 2.5).size(), 3U);
  const auto joined = joinAlongOutlines(runs, kOutlineLinksSquare, 2.5, LinkChoice::EveryOther);
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_EQ(joined[0], (Polyline{{2, 5}, {2, 0}, {4, 0}, {4, 5}}));
}

TEST(OutlineLinks, CloseNoRun) {
  const std::vector<RunOnOutlines> bow = {
      {{{2, 0}, {2, 1}, {3, 1}, {3, 0}}, OutlinePoint{0, 0, 2.0}, OutlinePoint{0, 0, 3.0}}};
  const std::vector<Polyline> joined = joinAlongOutlines(bow, kOutlineLinksSquare, 5.0);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0].size(), 4U);
}

}  // namespace
}  // namespace lamina
