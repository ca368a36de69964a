// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/hybrid.hpp"

#include <gtest/gtest.h>

#include "infill/rectilinear/grid_sections.hpp"
#include "infill/rectilinear/section_order.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

InfillRequest hybridSolid(double pitch, double angle_rad, HybridLines lines) {
  InfillRequest request;
  request.pitch_mm = request.spacing_mm = pitch;
  request.angle_rad = angle_rad;
  request.settings.hybrid.lines = lines;
  return request;
}

class Hybrid : public testing::TestWithParam<HybridLines> {};

TEST_P(Hybrid, LaysThePerimeterFirst) {
  const std::vector<FillPath> runs =
      hybrid({{circle({0, 0}, 15, 90), {}}}, hybridSolid(1.0, 0.0, GetParam()));
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].role, PathRole::OuterWall);
  EXPECT_TRUE(runs[0].is_closed);
  EXPECT_EQ(runs[1].role, PathRole::Infill);
}

TEST_P(Hybrid, RunsItsPassesAlongTheRaster) {
  for (const double angle : {0.0, M_PI / 2}) {
    const std::vector<FillPath> runs =
        hybrid({{rectangle(0, 0, 30, 30), {}}}, hybridSolid(1.0, angle, GetParam()));
    ASSERT_EQ(runs.size(), 2U);
    int passes = 0;
    int others = 0;
    for (std::size_t i = 1; i < runs[1].points.size(); ++i) {
      const Point2 motion = runs[1].points[i] - runs[1].points[i - 1];
      if (motion.norm() < 10.0) continue;
      ++(std::abs(motion.dot(Point2(-std::sin(angle), std::cos(angle)))) < 1e-6 ? passes : others);
    }
    EXPECT_GE(passes, 24);
    EXPECT_LE(others, 2) << "towards the points added at both borders";
  }
}

TEST_P(Hybrid, LaysOnePerimeterMoreEveryFewLayers) {
  InfillRequest request = hybridSolid(1.0, 0.0, GetParam());
  request.settings.hybrid.extra_perimeter_every = 3;
  const auto perimeters = [&](std::size_t layer) {
    request.layer = layer;
    const std::vector<FillPath> runs = hybrid({{circle({0, 0}, 15, 90), {}}}, request);
    return std::count_if(runs.begin(), runs.end(),
                         [](const FillPath& run) { return run.role == PathRole::OuterWall; });
  };
  EXPECT_EQ(perimeters(0), 1);
  EXPECT_EQ(perimeters(1), 1);
  EXPECT_EQ(perimeters(2), 2);
  EXPECT_EQ(perimeters(5), 2);
}

INSTANTIATE_TEST_SUITE_P(Lines, Hybrid, testing::Values(HybridLines::Fitted, HybridLines::Metal),
                         [](const testing::TestParamInfo<HybridLines>& lines) {
                           return lines.param == HybridLines::Fitted ? "Fitted" : "Metal";
                         });

/// A section that lines along y cross twice for x from 20 to 27 and from 33 to 41 [Flores2018, figure 50].
Regions concave() {
  return {
      {rectangle(0, 0, 60, 20), {reversed(rectangle(20, 9, 27, 12)), reversed(rectangle(33, 8, 41, 11))}}};
}

std::vector<BoustrophedonCell> concaveSections() {
  std::vector<Polygon> turned = outlines(concave());
  for (Polygon& outline : turned)
    for (Point2& point : outline) point = {point.y(), -point.x()};
  std::vector<BoustrophedonCell> sections;
  for (const GridSection& section : gridSections(turned, 1.0, {0.5, -0.5}))
    sections.push_back({{section.passes.front().front(), section.passes.front().back()},
                        {section.passes.back().front(), section.passes.back().back()},
                        section.passes.size()});
  return sections;
}

std::size_t jumpsInside(const Regions& regions, HybridLines lines, double angle) {
  const std::vector<FillPath> runs = hybrid(regions, hybridSolid(1.0, angle, lines));
  return static_cast<std::size_t>(std::count_if(
             runs.begin(), runs.end(), [](const FillPath& run) { return run.role == PathRole::Infill; })) -
         1;
}

/// [Flores2018, figure 50]
TEST(HybridJumps, AreNeededWhereAPassLineCrossesTheSectionTwice) {
  EXPECT_GE(jumpsInside(concave(), HybridLines::Metal, M_PI / 2), 1U);
  EXPECT_GE(jumpsInside(concave(), HybridLines::Fitted, M_PI / 2), 1U);
}

/// [Flores2018, figure 49]
TEST(HybridJumps, AreNoneInAConcavePartThatNoPassLineCrossesTwice) {
  const Regions notched = {
      {{{0, 0}, {60, 0}, {60, 30}, {40, 30}, {40, 15}, {20, 15}, {20, 30}, {0, 30}}, {}}};
  EXPECT_EQ(jumpsInside(notched, HybridLines::Metal, M_PI / 2), 0U);
  EXPECT_EQ(jumpsInside(notched, HybridLines::Fitted, M_PI / 2), 0U);
}

/// Travel in the order of [Flores2018, figure 50], by midpoints, by ends and optimised.
TEST(HybridJumps, AreShorterInAGreedyOrderThanInTheInitialOne) {
  const std::vector<BoustrophedonCell> sections = concaveSections();
  ASSERT_EQ(sections.size(), 7U);
  const Point2 start = entryPoint(sections[0], SectionEntry::FirstLeft);
  const SectionTravels travels = sectionTravels(sections, start);
  EXPECT_LT(travels.midpoints, travels.as_given);
  EXPECT_LT(travels.ends, travels.as_given);
  EXPECT_LE(travels.optimised, travels.ends + 1e-9);
  EXPECT_LE(travelLength(sections, shortestTour(sections, start)), travels.optimised + 1e-9);
  RecordProperty("as_given_mm", std::to_string(travels.as_given));
  RecordProperty("midpoints_mm", std::to_string(travels.midpoints));
  RecordProperty("ends_mm", std::to_string(travels.ends));
  RecordProperty("optimised_mm", std::to_string(travels.optimised));
}

}  // namespace
}  // namespace lamina
