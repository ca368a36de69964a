// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/layer_height_monitor/profile_counts.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

/// 100 clouds of 10 points each came: 60 were placed, 5 wait, 35 could not be used.
IntakeCounts hundredClouds() {
  IntakeCounts counts;
  counts.received = {100, 1000};
  counts.placed = {60, 600};
  counts.waiting = {5, 50};
  counts.without_frame = {1, 10};
  counts.malformed = {2, 20};
  counts.without_transform = {4, 40};
  counts.without_nozzle = {8, 80};
  counts.pushed_out = {20, 200};
  counts.lost = 7;
  counts.points_not_finite = 15;
  return counts;
}

/// Of the 60 placed with 585 points.
ProfileUse sixtyProfiles() {
  ProfileUse use;
  use.received = {60, 585};
  use.of_layers = {40, 390};
  use.of_no_layer = {10, 100};
  use.waiting = {3, 30};
  use.late = {5, 45};
  use.in_gap = {2, 20};
  use.points_outside = 11;
  return use;
}

void expectAccounted(const lamina_msgs::ProfileCounts& of) {
  EXPECT_EQ(of.received, of.of_layers + of.of_no_layer + of.waiting + of.without_frame + of.malformed +
                             of.without_transform + of.without_nozzle + of.pushed_out + of.in_gap + of.late);
  EXPECT_EQ(of.points_received, of.points_used + of.points_outside + of.points_not_finite +
                                    of.points_dropped + of.points_waiting);
}

TEST(ProfileCounts, AccountForEveryProfileAndEveryPoint) {
  const lamina_msgs::ProfileCounts counts = toMessage(hundredClouds(), sixtyProfiles());
  expectAccounted(counts);
  EXPECT_EQ(counts.received, 100U);
  EXPECT_EQ(counts.waiting, 8U);
  EXPECT_EQ(counts.points_used, 479U);
  EXPECT_EQ(counts.points_dropped, 350U + 65U);
  EXPECT_EQ(counts.lost, 7U);
  EXPECT_EQ(unused(counts), 35U + 7U + 7U);
}

TEST(ProfileCounts, OfAToolpathLeaveOutWhatWasBefore) {
  IntakeCounts now = hundredClouds();
  now.received = {130, 1300};
  now.placed = {93, 930};  // 60 before, and of the 35 that waited or came since all but 2
  now.waiting = {2, 20};
  const IntakeCounts counts = since(hundredClouds(), now);
  EXPECT_EQ(counts.received.clouds, 35U) << "30 that came and 5 that waited";
  EXPECT_EQ(counts.placed.clouds, 33U);
  EXPECT_EQ(counts.pushed_out.clouds, 0U);
  EXPECT_EQ(counts.lost, 0U);
  ProfileUse use;
  use.received = use.of_layers = {33, 330};
  expectAccounted(toMessage(counts, use));
}

}  // namespace
}  // namespace lamina
