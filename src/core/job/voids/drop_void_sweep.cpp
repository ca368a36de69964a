// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/drop_void_sweep.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr int kSteps = 8;
constexpr double kStep = 0.05;

/// Of layers, each with other drops besides its own.
DiscCoverage coverageOf(const std::vector<DropLayer>& layers, const std::vector<std::vector<Point2>>& drops,
                        Progress& progress) {
  std::vector<DiscCoverage> each(layers.size());
  parallelFor(
      layers.size(),
      [&](std::size_t i) {
        each[i] = discCoverage(drops[i], layers[i].diameter_mm, borders(contoursOf(layers[i])));
      },
      progress, "measure");
  DiscCoverage all;
  for (const DiscCoverage& layer : each) {
    all.voids += layer.voids;
    all.uncovered_mm2 += layer.uncovered_mm2;
    all.largest_mm2 = std::max(all.largest_mm2, layer.largest_mm2);
  }
  return all;
}

std::vector<std::vector<Point2>> dropsOf(const std::vector<DropLayer>& layers) {
  std::vector<std::vector<Point2>> drops;
  drops.reserve(layers.size());
  for (const DropLayer& layer : layers) drops.push_back(layer.drops);
  return drops;
}

}  // namespace

std::vector<DropSweepStep> sweepDropVoids(const DropProgram& program, const DropVoidSettings& settings,
                                          Progress& progress) {
  const std::vector<DropLayer> layers = dropLayers(program);
  const std::vector<std::vector<Point2>> prior = dropsOf(layers);
  DropSweepStep step;
  step.inside_mm2 =
      coverageOf(layers, std::vector<std::vector<Point2>>(layers.size()), progress).uncovered_mm2;
  step.before = coverageOf(layers, prior, progress);
  std::vector<DropSweepStep> steps;
  for (int i = 0; i <= kSteps; ++i) {
    DropVoidSettings tried = settings;
    tried.overlap = kStep * i;
    const DropVoidReport report = reportDropVoids(program, tried, progress);
    std::vector<std::vector<Point2>> drops = prior;
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const std::vector<Point2> added = newDrops(report.voids[l]);
      drops[l].insert(drops[l].end(), added.begin(), added.end());
    }
    step.overlap = tried.overlap;
    step.voids = report.count();
    step.reading = report.overlap;
    step.is_worth_it = report.is_worth_it;
    step.after = coverageOf(layers, drops, progress);
    steps.push_back(step);
  }
  return steps;
}

double uncoveredPercent(const DropSweepStep& step, const DiscCoverage& coverage) {
  return step.inside_mm2 > 0.0 ? 100.0 * coverage.uncovered_mm2 / step.inside_mm2 : 0.0;
}

std::string sweepCsv(const std::vector<DropSweepStep>& steps) {
  std::string csv =
      "allowed_overlap,voids,drops,new_drops,greatest_linear_overlap,greatest_area_overlap,"
      "overlap_per_new_drop,overlap_per_drop,uncovered_percent_before,uncovered_percent_after,"
      "largest_before_mm2,largest_after_mm2,worth_it\n";
  for (const DropSweepStep& step : steps) {
    char row[320];
    std::snprintf(row, sizeof row, "%.2f,%zu,%zu,%zu,%.6f,%.6f,%.6f,%.6f,%.4f,%.4f,%.6f,%.6f,%d\n",
                  step.overlap, step.voids, step.reading.prior, step.reading.added,
                  step.reading.greatest_linear, step.reading.greatest_area, step.reading.perNewDrop(),
                  step.reading.perDrop(), uncoveredPercent(step, step.before),
                  uncoveredPercent(step, step.after), step.before.largest_mm2, step.after.largest_mm2,
                  step.is_worth_it ? 1 : 0);
    csv += row;
  }
  return csv;
}

}  // namespace lamina
