// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/resident_pages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

/// What of files is in memory [kB].
std::size_t residentOfFiles() {
  std::ifstream status("/proc/self/status");
  const std::string name = "RssFile:";
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name, 0) == 0) return std::stoul(line.substr(name.size()));
  return 0;
}

TEST(ResidentPages, WhatOnlyTheStartUsedTakesNoMemory) {
  const std::size_t before_kb = residentOfFiles();
  EXPECT_GT(releaseStartPages(), 0U);
  EXPECT_LT(residentOfFiles(), before_kb);
}

TEST(ResidentPages, WhatTheLoaderAndTheProgramWroteStays) {
  static const std::array<const char*, 3> moved = {"one", "two", "three"};  // addresses that the loader set
  static std::vector<int> written(1000);
  std::iota(written.begin(), written.end(), 0);
  releaseStartPages();
  EXPECT_STREQ(moved[2], "three");
  EXPECT_EQ(std::accumulate(written.begin(), written.end(), 0), 499500);
}

TEST(ResidentPages, ErrorsFindTheirHandlersAfterwards) {
  releaseStartPages();
  try {
    throw InvalidInput("3 layers; expected 4");
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("3 layers; expected 4"), std::string::npos);
  }
}

TEST(ResidentPages, OtherThreadsGoOnMeanwhile) {
  std::vector<std::size_t> sums(64);
  parallelFor(sums.size(), [&](std::size_t i) {
    if (i % 8 == 0) releaseStartPages();
    for (std::size_t k = 1; k <= 1000; ++k) sums[i] += k * i;
  });
  for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], 500500 * i);
}

}  // namespace
}  // namespace lamina
