// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/section_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

/// Lines along x from y0 upwards, 1 mm apart.
BoustrophedonCell block(double x0, double x1, double y0, std::size_t lines) {
  const double top = y0 + static_cast<double>(lines - 1);
  return {{Point2(x0, y0), Point2(x1, y0)}, {Point2(x0, top), Point2(x1, top)}, lines};
}

std::vector<BoustrophedonCell> randomSections(Random& random, int count) {
  std::vector<BoustrophedonCell> sections;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0, 100);
    sections.push_back(block(x, x + random.uniform(1, 30), random.uniform(0, 100),
                             static_cast<std::size_t>(random.uniform(1, 9))));
  }
  return sections;
}

bool visitsEachOnce(const SectionTour& tour, std::size_t count) {
  std::set<std::size_t> seen;
  for (const SectionVisit& visit : tour) seen.insert(visit.section);
  return tour.size() == count && seen.size() == count;
}

double lengthFrom(const Point2& start, const std::vector<BoustrophedonCell>& sections,
                  const SectionTour& tour) {
  const Point2 first = entryPoint(sections[tour[0].section], tour[0].entry);
  return (first - start).norm() + travelLength(sections, tour);
}

TEST(SectionOrder, LeavesAnEvenSectionOnTheSideItEntered) {
  const BoustrophedonCell even = block(0, 10, 0, 4);
  EXPECT_EQ(exitOf(even, SectionEntry::FirstLeft), SectionEntry::LastLeft);
  EXPECT_EQ(exitOf(even, SectionEntry::LastRight), SectionEntry::FirstRight);
}

TEST(SectionOrder, LeavesAnOddSectionOnTheOtherSide) {
  const BoustrophedonCell odd = block(0, 10, 0, 3);
  EXPECT_EQ(exitOf(odd, SectionEntry::FirstLeft), SectionEntry::LastRight);
  EXPECT_EQ(exitOf(odd, SectionEntry::LastLeft), SectionEntry::FirstRight);
}

TEST(SectionOrder, ByMidpointsGoesToTheNearestMidpointAndReversesFromALastLine) {
  // From the midpoint (5, 3) of the last line: first line of the second at 20 mm, last line of the third
  // at 7.
  const std::vector<BoustrophedonCell> sections = {block(0, 10, 0, 4), block(20, 30, 3, 2),
                                                   block(0, 10, 6, 5)};
  const SectionTour tour = tourByMidpoints(sections);
  ASSERT_TRUE(visitsEachOnce(tour, 3));
  EXPECT_EQ(tour[0].section, 0U);
  EXPECT_EQ(tour[1].section, 2U) << "its first line is 3 mm above";
  EXPECT_EQ(tour[1].entry, SectionEntry::FirstLeft);
  EXPECT_EQ(tour[2].section, 1U);
  EXPECT_EQ(tour[2].entry, SectionEntry::LastLeft) << "its last line is nearer, and it has an even number";
}

TEST(SectionOrder, ByEndsEntersAtTheNearestEnd) {
  const std::vector<BoustrophedonCell> sections = {block(0, 10, 0, 4), block(12, 20, 3, 3)};
  const SectionTour tour = tourByEnds(sections, {9, -1});
  EXPECT_EQ(tour[0].entry, SectionEntry::FirstRight);
  EXPECT_EQ(tour[1].entry, SectionEntry::FirstLeft) << "2 mm from (10, 3), where the first section ends";
  EXPECT_DOUBLE_EQ(travelLength(sections, tour), 2.0);
}

TEST(SectionOrder, OfNothingIsEmpty) {
  EXPECT_TRUE(tourByMidpoints({}).empty());
  EXPECT_TRUE(improvedTour({}, {0, 0}).empty());
  EXPECT_TRUE(shortestTour({}, {0, 0}).empty());
}

TEST(SectionOrder, IsNeverShorterThanTheShortestNorLongerThanWhatItImproves) {
  EXPECT_TRUE(rc::check("random sections", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const int count = static_cast<int>(random.uniform(1, 7));
    const std::vector<BoustrophedonCell> sections = randomSections(random, count);
    const Point2 start(random.uniform(0, 100), random.uniform(0, 100));
    const SectionTour shortest = shortestTour(sections, start);
    const SectionTour improved = improvedTour(sections, start);
    RC_ASSERT(visitsEachOnce(shortest, sections.size()));
    RC_ASSERT(visitsEachOnce(improved, sections.size()));
    RC_ASSERT(visitsEachOnce(tourByMidpoints(sections), sections.size()));
    const double best = lengthFrom(start, sections, shortest);
    const double better = lengthFrom(start, sections, improved);
    RC_ASSERT(best <= better + 1e-9);
    RC_ASSERT(better <= lengthFrom(start, sections, tourByEnds(sections, start)) + 1e-9);
  }));
}

TEST(SectionOrder, ImprovedComesWithinFivePercentOfTheShortestOnAverage) {
  Random random(5);
  double improved = 0.0;
  double shortest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const std::vector<BoustrophedonCell> sections = randomSections(random, 8);
    improved += lengthFrom({0, 0}, sections, improvedTour(sections, {0, 0}));
    shortest += lengthFrom({0, 0}, sections, shortestTour(sections, {0, 0}));
  }
  EXPECT_LT(improved, 1.05 * shortest);
  RecordProperty("gap_percent", std::to_string(100.0 * (improved / shortest - 1.0)));
}

TEST(SectionOrder, RefusesTheShortestTourOfMany) {
  Random random(1);
  EXPECT_THROW(shortestTour(randomSections(random, 13), {0, 0}), InvalidInput);
}

}  // namespace
}  // namespace lamina
