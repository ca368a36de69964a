// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/regional_overhangs.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

/// A table of 20 x 20 mm, from layer 5 of 8 on, on a foot of 4 x 20 mm at its left side.
StackedMaterial table() {
  NoProgress nobody;
  return stackedMaterial(test::layersOf(8,
                                        [](int i) {
                                          const double right = i < 5 ? 4.0 : 20.0;
                                          return std::vector<Polygon>{rectangle(0, 0, right, 20)};
                                        }),
                         0.005, std::nullopt, nobody);
}

/// The same area in all layers.
std::vector<Regions> inAll(const Polygon& area) { return std::vector<Regions>(8, {Region{area, {}}}); }

PlanSettings held() {
  PlanSettings settings;
  settings.supports.use = true;
  settings.supports.angle_deg = 45.0;
  return settings;
}

RegionalOverhangs found(const PlanSettings& settings, const SupportRegions& regions) {
  NoProgress nobody;
  return regionalOverhangs(table(), settings, regions, 0.2, nobody);
}

const Polygon kBeyondTwelve = rectangle(12, -1, 30, 30);

TEST(RegionalOverhangs, WithoutRegionsAreThoseOfThePart) {
  const RegionalOverhangs all = found(held(), {});
  EXPECT_NEAR(area(all.held[5]), 16.0 * 20.0, 1e-6);
  EXPECT_EQ(all.blocked_mm2, 0.0);
  for (const std::size_t i : {0, 4, 6, 7}) EXPECT_TRUE(all.held[i].empty());
}

TEST(RegionalOverhangs, LeaveOutWhatIsBlocked) {
  SupportMarks marks;
  marks.never = inAll(kBeyondTwelve);
  marks.always = std::vector<Regions>(8);
  const RegionalOverhangs rest = found(held(), {nullptr, &marks});
  EXPECT_NEAR(area(rest.held[5]), 8.0 * 20.0, 1e-6);
  EXPECT_NEAR(rest.blocked_mm2, 8.0 * 20.0, 1e-6);
}

TEST(RegionalOverhangs, AreOnlyWhatIsMarkedWhereSupportsAreOff) {
  SupportMarks marks;
  marks.always = inAll(kBeyondTwelve);
  marks.unmarked = UnmarkedOverhangs::LeftOut;
  EXPECT_NEAR(area(found(held(), {nullptr, &marks}).held[5]), 8.0 * 20.0, 1e-6);
}

TEST(RegionalOverhangs, FollowTheSettingsOfVariants) {
  PlanVariant without{held(), inAll(kBeyondTwelve)};
  without.settings.supports.use = false;
  std::vector<PlanVariant> variants = {without};
  EXPECT_NEAR(area(found(held(), {&variants, nullptr}).held[5]), 8.0 * 20.0, 1e-6);
  // Supports in the region alone.
  SupportMarks marks;
  marks.unmarked = UnmarkedOverhangs::LeftOut;
  variants = {PlanVariant{held(), inAll(rectangle(14, -1, 30, 30))}};
  EXPECT_NEAR(area(found(held(), {&variants, &marks}).held[5]), 6.0 * 20.0, 1e-6);
}

TEST(RegionalOverhangs, HoldUpLeaningWallsByTheAngleOfTheRegion) {
  // Walls that lean 45 deg on the right: 0.2 mm a layer.
  NoProgress nobody;
  const StackedMaterial leaning = stackedMaterial(
      test::layersOf(8, [](int i) { return std::vector<Polygon>{rectangle(0, 0, 10.0 + 0.2 * i, 20)}; }),
      0.005, std::nullopt, nobody);
  PlanSettings tolerant = held();
  tolerant.supports.angle_deg = 60.0;
  PlanVariant strict{held(), inAll(rectangle(-1, -1, 30, 10))};
  strict.settings.supports.angle_deg = 30.0;
  const std::vector<PlanVariant> variants = {strict};
  const RegionalOverhangs both = regionalOverhangs(leaning, tolerant, {&variants, nullptr}, 0.2, nobody);
  SupportMarks marks;
  marks.always = inAll(rectangle(-1, -1, 30, 10));
  const RegionalOverhangs forced = regionalOverhangs(leaning, tolerant, {nullptr, &marks}, 0.2, nobody);
  for (std::size_t i = 1; i < 8; ++i) {
    EXPECT_NEAR(area(both.held[i]), 0.2 * 10.0, 1e-3);
    EXPECT_NEAR(area(forced.held[i]), 0.2 * 10.0, 1e-3);
  }
}

}  // namespace
}  // namespace lamina
