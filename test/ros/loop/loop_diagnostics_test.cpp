// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/height_controller/loop_diagnostics.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

namespace lamina {
namespace {

/// Values that begin with a word, but for some of them.
std::uint64_t sumOf(const diagnostic_updater::DiagnosticStatusWrapper& status, const std::string& word,
                    const std::string& but) {
  std::uint64_t sum = 0;
  for (const auto& value : status.values)
    if (value.key.rfind(word, 0) == 0 && but.find(value.key) == std::string::npos)
      sum += std::strtoull(value.value.c_str(), nullptr, 10);
  return sum;
}

/// Each count a power of two: none stands for another.
TEST(LoopDiagnostics, AccountForCloudsPointsAndReadings) {
  FeedCounts feed;
  feed.received = 1023;
  feed.placed = 768;
  feed.waiting = 1;
  feed.without_frame = 2;
  feed.without_offset = 4;
  feed.malformed = 8;
  feed.without_transform = 16;
  feed.pushed_out = 32;
  feed.of_former_print = 64;
  LoopCounts loop;
  loop.clouds_waiting = 128;
  loop.clouds_read = 256;
  loop.clouds_late = 512;
  loop.readings_used = 1;
  loop.readings_contested = 2;
  loop.readings_believed = 4;
  loop.readings_below = 8;
  loop.points = {511, 1, 2, 4, 8, 16, 32, 64, 128, 256};
  diagnostic_updater::DiagnosticStatusWrapper status;
  addCounts(feed, loop, status);
  EXPECT_EQ(sumOf(status, "clouds", "clouds received, clouds placed"), 1023U);
  EXPECT_EQ(sumOf(status, "clouds received", ""), 1023U);
  EXPECT_EQ(sumOf(status, "points", "points received"), 511U);
  EXPECT_EQ(sumOf(status, "points received", ""), 511U);
  EXPECT_EQ(sumOf(status, "readings", ""), 15U);
}

}  // namespace
}  // namespace lamina
