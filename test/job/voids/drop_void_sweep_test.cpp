// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/drop_void_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/drop_programs.hpp"

namespace lamina {
namespace {

std::vector<DropSweepStep> sweepOf(const std::string& text) {
  NoProgress progress;
  return sweepDropVoids(parseDropProgram(text, {}), {}, progress);
}

TEST(DropVoidSweep, PutsAMissingDropBackAtAnyDegreeAndFillsPoresAboveTheirOwn) {
  // The pores of a square lattice are admitted from 1 - 1 / sqrt(2) = 29.3 % on, 64 of them.
  const std::vector<DropSweepStep> steps = sweepOf(test::squareProgram({{4, 4}}));
  ASSERT_EQ(steps.size(), 9U);
  for (const DropSweepStep& step : steps) {
    EXPECT_EQ(step.reading.prior, 80U);
    EXPECT_LE(step.reading.greatest_linear, step.overlap + 1e-6);
    if (step.overlap < 0.29) {
      EXPECT_EQ(step.reading.added, 1U) << step.overlap;
      EXPECT_NEAR(step.reading.perDrop(), 0.0, 1e-9);
    } else {
      EXPECT_GE(step.reading.added, 60U) << step.overlap;
      EXPECT_GT(step.reading.perDrop(), 0.2) << "the overlap in the part rises fast";
    }
  }
}

TEST(DropVoidSweep, MeasuresTheWholeInsideBeforeAndAfter) {
  // Within the contour of 8 x 8 pitches there is a void of 1.6438, and pores of 0.2146.
  const std::vector<DropSweepStep> steps = sweepOf(test::squareProgram({{4, 4}}));
  for (const DropSweepStep& step : steps) {
    EXPECT_NEAR(step.inside_mm2, 64.0, 0.1);
    EXPECT_NEAR(step.before.largest_mm2, 1.6438, 0.02);
    EXPECT_NEAR(uncoveredPercent(step, step.before), 100.0 * (0.2146 + 0.7854 / 64.0), 0.5);
    if (step.overlap > 0.29) continue;
    EXPECT_NEAR(step.after.largest_mm2, 0.2146, 0.005) << "a pore";
    EXPECT_NEAR(uncoveredPercent(step, step.after), 21.46, 0.5);
  }
}

TEST(DropVoidSweep, IsATableOfOneLinePerStep) {
  const std::string csv = sweepCsv(sweepOf(test::squareProgram({{4, 4}})));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 10);
  const std::string names = csv.substr(0, csv.find('\n'));
  const std::size_t columns = static_cast<std::size_t>(std::count(names.begin(), names.end(), ','));
  EXPECT_EQ(columns, 12U);
  for (std::size_t at = 0; at < csv.size(); at = csv.find('\n', at) + 1) {
    const std::string line = csv.substr(at, csv.find('\n', at) - at);
    EXPECT_EQ(static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')), columns) << line;
  }
  EXPECT_NE(csv.find("\n0.20,1,80,1,0.000000"), std::string::npos) << csv;
}

}  // namespace
}  // namespace lamina
