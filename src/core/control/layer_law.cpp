// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/control/path_low_pass.hpp"

namespace lamina {
namespace {

constexpr double kSameAmount = 1e-6;

/// Greatest change of the amount from a cell to the next of its run; that of the last one is to the first.
double greatestStep(const LayerCells& cells, const CellRun& run, std::size_t cell, double feeder_rate_s) {
  const std::size_t next = cell + 1 < run.first + run.count ? cell + 1 : run.first;
  const double speed = std::max(cells.speed_mm_s[cell], cells.speed_mm_s[next]);
  return greatestSlope(feeder_rate_s, speed) * run.cellLength();
}

/// The greatest function below the values, or with sign -1 the least above, that is as flat as the steps ask.
void boundSlope(std::vector<double>& values, const LayerCells& cells, const CellRun& run,
                double feeder_rate_s, double sign) {
  const std::size_t end = run.first + run.count;
  const auto bound = [&](std::size_t cell, std::size_t by, double step) {
    values[cell] = sign * std::min(sign * values[cell], sign * values[by] + step);
  };
  const std::size_t rounds = run.is_closed ? 2 : 1;  // what holds at the seam goes round once more
  for (std::size_t round = 0; round < rounds; ++round) {
    if (run.is_closed) bound(run.first, end - 1, greatestStep(cells, run, end - 1, feeder_rate_s));
    for (std::size_t i = run.first + 1; i < end; ++i)
      bound(i, i - 1, greatestStep(cells, run, i - 1, feeder_rate_s));
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    if (run.is_closed) bound(end - 1, run.first, greatestStep(cells, run, end - 1, feeder_rate_s));
    for (std::size_t i = end - 1; i > run.first; --i)
      bound(i - 1, i, greatestStep(cells, run, i - 1, feeder_rate_s));
  }
}

/// Midway between the flat functions below and above, which is as flat as they are.
void limitSlope(std::vector<double>& amount, const LayerCells& cells, double feeder_rate_s) {
  std::vector<double> above = amount;
  for (const CellRun& run : cells.runs) {
    boundSlope(amount, cells, run, feeder_rate_s, 1.0);
    boundSlope(above, cells, run, feeder_rate_s, -1.0);
  }
  for (std::size_t i = 0; i < amount.size(); ++i) amount[i] = 0.5 * (amount[i] + above[i]);
}

double volumeChange(const LayerCells& cells, const std::vector<double>& amount) {
  double change = 0.0;
  double planned = 0.0;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const double volume = run.cellLength() * cells.height_mm[i] * cells.width_mm[i];
      change += volume * amount[i];
      planned += volume;
    }
  }
  return planned > 0.0 ? change / planned : 0.0;
}

double shareOfLength(const LayerCells& cells, const std::vector<double>& wanted,
                     const std::vector<double>& limited) {
  std::vector<double> differs(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    differs[i] = std::abs(wanted[i] - limited[i]) > kSameAmount ? 1.0 : 0.0;
  return meanOverCells(cells, differs);
}

}  // namespace

double greatestSlope(double feeder_rate_s, double speed_mm_s) {
  return speed_mm_s > 0.0 ? feeder_rate_s / speed_mm_s : std::numeric_limits<double>::infinity();
}

LayerCorrection limitedCorrection(const LayerCells& cells, const std::vector<double>& wanted,
                                  const LoopSettings& settings) {
  LayerCorrection correction;
  correction.amount = wanted;
  for (double& amount : correction.amount) {
    if (!std::isfinite(amount)) amount = 0.0;
    amount = std::clamp(amount, settings.least_amount, settings.greatest_amount);
  }
  const double change = volumeChange(cells, correction.amount);
  if (std::abs(change) > settings.layer_volume)
    for (double& amount : correction.amount) amount *= settings.layer_volume / std::abs(change);
  // A slope is no want that is not met: it is counted before.
  correction.limited_share = shareOfLength(cells, wanted, correction.amount);
  limitSlope(correction.amount, cells, settings.feeder_rate_s);
  return correction;
}

LayerCorrection freeCorrection(const LayerCells& cells, const LayerKnowledge& known,
                               const LoopSettings& settings) {
  const std::vector<double> error = lowPassed(known.error_mm, cells, settings.low_pass_mm);
  std::vector<double> wanted(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    wanted[i] = (1.0 + settings.gain * error[i] / cells.height_mm[i]) / known.gain[i] - 1.0;
  return limitedCorrection(cells, wanted, settings);
}

LayerCorrection learntCorrection(const LayerCells& cells, const std::vector<double>& gain,
                                 const LoopSettings& settings) {
  std::vector<double> wanted(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) wanted[i] = 1.0 / gain[i] - 1.0;
  return limitedCorrection(cells, wanted, settings);
}

std::vector<double> fadedCorrection(const LayerCells& cells, const std::vector<double>& from,
                                    const std::vector<double>& to, std::size_t begin,
                                    const LoopSettings& settings) {
  std::vector<double> faded = from;
  if (begin >= cells.size()) return faded;
  double last = from[begin];
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = std::max(begin, run.first); i < run.first + run.count; ++i) {
      const double step = greatestSlope(settings.feeder_rate_s, cells.speed_mm_s[i]) * run.cellLength();
      last = std::clamp(to[i], last - step, last + step);
      faded[i] = last;
    }
  }
  return faded;
}

}  // namespace lamina
