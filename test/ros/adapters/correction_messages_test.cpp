// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "correction_messages.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/error.hpp"

namespace {

using lamina::CorrectionMap;
using lamina::digestOf;
using lamina::isRefusalOfPlan;
using lamina::MissedMap;
using lamina::missedOf;
using lamina::PlaceOnLayer;
using lamina::refusedPlan;
using lamina::toCore;

CorrectionMap twoPaths() {
  CorrectionMap map{"0123abcd", 7, 3, {}};
  map.paths.push_back({2, 0.5, {{0.125, -0.25, 0.5}, {-0.1, 0.0, 1.0 / 3.0}}});
  map.paths.push_back({5, 1.0 / 3.0, {{0.3, 0.0, -0.07}}});
  return map;
}

TEST(CorrectionMessages, SayWithWhatTheLayerAboveBegins) {
  CorrectionMap map = twoPaths();
  map.ahead = {0.05, {0.1, -0.25}};
  auto message = toMessage(map);
  EXPECT_EQ(message.ahead_interval, 0.05);
  EXPECT_EQ(message.ahead.at(1), -0.25);
  const CorrectionMap back = toCore(message);
  EXPECT_EQ(back.ahead.interval_s, 0.05);
  EXPECT_EQ(back.ahead.amount, map.ahead.amount);
  message.ahead[1] = -0.24;
  EXPECT_THROW(toCore(message), lamina::InvalidInput) << "another digest";
}

TEST(CorrectionMessages, AreInMetres) {
  const auto message = toMessage(twoPaths());
  EXPECT_EQ(message.toolpath_id, "0123abcd");
  EXPECT_EQ(message.layer, 7U);
  EXPECT_EQ(message.sequence, 3U);
  EXPECT_EQ(message.digest.size(), 16U);
  ASSERT_EQ(message.paths.size(), 2U);
  EXPECT_EQ(message.paths[0].path, 2U);
  EXPECT_DOUBLE_EQ(message.paths[0].station, 0.0005);
  EXPECT_DOUBLE_EQ(message.paths[0].amount.at(0), 0.125);
  EXPECT_DOUBLE_EQ(message.paths[0].speed.at(0), -0.25);
  EXPECT_DOUBLE_EQ(message.paths[0].dz.at(0), 0.0005);
}

TEST(CorrectionMessages, KeepTheDigestThroughMetres) {
  const auto property = [] {
    CorrectionMap map = twoPaths();
    const auto thirds_of_um = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-300000, 300001));
    for (const int each : thirds_of_um) map.paths[1].stations.push_back({0.1, 0.0, each / 3e3});
    const auto message = toMessage(map);
    const CorrectionMap read = toCore(message);
    RC_ASSERT(digestOf(read) == message.digest);
    RC_ASSERT(toMessage(read).digest == message.digest);
    RC_ASSERT(read.paths[1].stations.size() == map.paths[1].stations.size());
    for (std::size_t i = 0; i < map.paths[1].stations.size(); ++i) {
      const double dz_mm = map.paths[1].stations[i].dz_mm;
      RC_ASSERT(std::abs(read.paths[1].stations[i].dz_mm - dz_mm) <= 1e-12 * std::abs(dz_mm));
    }
  };
  ASSERT_TRUE(rc::check(property));
}

TEST(CorrectionMessages, TellWhatALayerMissesOfItsMap) {
  const auto none = missedOf(toMessage(MissedMap{7, 2.5, "none came", {}}, "part", ""));
  ASSERT_TRUE(none);
  EXPECT_EQ(none->layer, 7U);
  EXPECT_EQ(none->waited_s, 2.5);
  EXPECT_EQ(none->reason, "none came");
  EXPECT_FALSE(none->held_from);
  const auto late = missedOf(toMessage(MissedMap{7, 0.0, {}, PlaceOnLayer{2, 12.5}}, "part", "digest"));
  ASSERT_TRUE(late && late->held_from);
  EXPECT_EQ(late->held_from->path, 2U);
  EXPECT_DOUBLE_EQ(late->held_from->along_mm, 12.5);
  const auto whole = missedOf(toMessage(MissedMap{7, 0.0, {}, {}}, "part", "digest"));
  ASSERT_TRUE(whole && whole->held_from) << "it takes the place of what was reported before";
  EXPECT_EQ(whole->held_from->path, 0U);
  EXPECT_EQ(whole->held_from->along_mm, 0.0);
  EXPECT_FALSE(missedOf(toMessage(MissedMap{7, 0.0, "speeds", {}}, "part", "digest"))) << "of a later map";
}

TEST(CorrectionMessages, TellOfPlansThatAreNotFollowed) {
  const auto refused = toMessage(refusedPlan("out of reach"), "plan", "");
  EXPECT_TRUE(isRefusalOfPlan(refused));
  EXPECT_EQ(refused.reason, "the plan is not gone on with: out of reach");
  EXPECT_FALSE(isRefusalOfPlan(toMessage(MissedMap{0, 2.0, "none came within 2 s", {}}, "plan", "")))
      << "its first map is missed";
  EXPECT_FALSE(isRefusalOfPlan(toMessage(MissedMap{0, 0.0, {}, {}}, "plan", "digest")));
}

void expectRefused(const lamina_msgs::CorrectionMap& message, const std::string& why) {
  try {
    toCore(message);
    FAIL() << "expected to be refused: " << why;
  } catch (const lamina::InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

TEST(CorrectionMessages, AreRefusedWhenAnyValueChanged) {
  auto message = toMessage(twoPaths());
  message.paths[0].amount[1] = 0.2;
  expectRefused(message, "the digest is '" + message.digest + "'");
  message = toMessage(twoPaths());
  message.layer = 8;
  expectRefused(message, "correction of layer 8");
}

TEST(CorrectionMessages, AreRefusedWhenValuesAreMissingOrNone) {
  auto message = toMessage(twoPaths());
  message.paths[0].speed.pop_back();
  expectRefused(message, "path 2: 1 speeds to 2 amounts");
  message = toMessage(twoPaths());
  message.paths[1].dz.clear();
  expectRefused(message, "path 5: 0 heights to 1 amounts");
  message = toMessage(twoPaths());
  message.paths[1].dz[0] = std::numeric_limits<double>::quiet_NaN();
  expectRefused(message, "correction of path 5, station 0: a value is not finite");
}

}  // namespace
