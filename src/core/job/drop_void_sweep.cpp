// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/drop_void_sweep.hpp"

#include <cstdio>

namespace lamina {
namespace {

constexpr int kSteps = 8;
constexpr double kStep = 0.05;

DropSweepStep stepOf(const DropVoidReport& report, double overlap) {
  DropSweepStep step;
  step.overlap = overlap;
  step.voids = report.count();
  step.reading = report.overlap;
  step.uncovered_before_mm2 = report.uncoveredBefore();
  step.uncovered_after_mm2 = report.uncoveredAfter();
  step.largest_after_mm2 = report.largestAfter();
  step.is_worth_it = report.is_worth_it;
  return step;
}

}  // namespace

std::vector<DropSweepStep> sweepDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                                          Progress& progress) {
  std::vector<DropSweepStep> steps;
  for (int i = 0; i <= kSteps; ++i) {
    DropVoidSettings tried = settings;
    tried.overlap = kStep * i;
    steps.push_back(stepOf(reportDropVoids(program, tried, progress), tried.overlap));
  }
  return steps;
}

std::string sweepCsv(const std::vector<DropSweepStep>& steps) {
  std::string csv =
      "allowed_overlap,voids,drops,new_drops,greatest_linear_overlap,greatest_area_overlap,"
      "overlap_per_new_drop,overlap_per_drop,uncovered_before_mm2,uncovered_after_mm2,largest_after_mm2,"
      "worth_it\n";
  for (const DropSweepStep& step : steps) {
    char row[320];
    std::snprintf(row, sizeof row, "%.2f,%zu,%zu,%zu,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%d\n", step.overlap,
                  step.voids, step.reading.prior, step.reading.added, step.reading.greatest_linear,
                  step.reading.greatest_area, step.reading.perNewDrop(), step.reading.perDrop(),
                  step.uncovered_before_mm2, step.uncovered_after_mm2, step.largest_after_mm2,
                  step.is_worth_it ? 1 : 0);
    csv += row;
  }
  return csv;
}

}  // namespace lamina
