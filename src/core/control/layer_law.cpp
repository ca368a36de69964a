// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "lamina/control/path_low_pass.hpp"

namespace lamina {
namespace {

constexpr double kSameAmount = 1e-6;

/// Greatest change of the amount from each cell to the next of its run; that of the last one is to the first.
std::vector<double> greatestSteps(const LayerCells& cells, const CellRun& run, double feeder_rate_s) {
  std::vector<double> steps(run.count);
  double speed = -1.0;
  double step = 0.0;
  for (std::size_t i = 0; i < run.count; ++i) {
    const std::size_t cell = run.first + i;
    const std::size_t next = i + 1 < run.count ? cell + 1 : run.first;
    const double fastest = std::max(cells.speed_mm_s[cell], cells.speed_mm_s[next]);
    if (fastest != speed) step = greatestSlope(feeder_rate_s, fastest) * run.cellLength();
    speed = fastest;
    steps[i] = step;
  }
  return steps;
}

/// The greatest function below the values, or with sign -1 the least above, that is as flat as the steps ask.
void boundSlope(double* values, const std::vector<double>& steps, bool is_closed, double sign) {
  const std::size_t count = steps.size();
  const auto bound = [&](std::size_t cell, std::size_t by, double step) {
    values[cell] = sign * std::min(sign * values[cell], sign * values[by] + step);
  };
  const std::size_t rounds = is_closed ? 2 : 1;  // what holds at the seam goes round once more
  for (std::size_t round = 0; round < rounds; ++round) {
    if (is_closed) bound(0, count - 1, steps[count - 1]);
    for (std::size_t i = 1; i < count; ++i) bound(i, i - 1, steps[i - 1]);
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    if (is_closed) bound(count - 1, 0, steps[count - 1]);
    for (std::size_t i = count - 1; i > 0; --i) bound(i - 1, i, steps[i - 1]);
  }
}

/// Share of the way from the function below to the one above that has the volume asked for.
double shareOfWay(const LayerCells& cells, const CellRun& run, const double* wanted, const double* below,
                  const double* above) {
  double asked = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < run.count; ++i) {
    const double section = cells.height_mm[run.first + i] * cells.width_mm[run.first + i];
    asked += section * (wanted[i] - below[i]);
    whole += section * (above[i] - below[i]);
  }
  return whole > 0.0 ? std::clamp(asked / whole, 0.0, 1.0) : 0.0;
}

/// What each run gets between the flat functions below and above it, which is as flat as they are.
enum class SlopeLimit : std::uint8_t {
  Midway,     ///< an edge stays where it is
  SameVolume  ///< a peak raises the rest by no more than it loses
};

void limitSlope(std::vector<double>& amount, const LayerCells& cells, double feeder_rate_s,
                SlopeLimit limit) {
  std::vector<double> below = amount;
  std::vector<double> above = amount;
  for (const CellRun& run : cells.runs) {
    const std::vector<double> steps = greatestSteps(cells, run, feeder_rate_s);
    double* const asked = amount.data() + run.first;
    double* const least = below.data() + run.first;
    double* const most = above.data() + run.first;
    boundSlope(least, steps, run.is_closed, 1.0);
    boundSlope(most, steps, run.is_closed, -1.0);
    const double share = limit == SlopeLimit::Midway ? 0.5 : shareOfWay(cells, run, asked, least, most);
    for (std::size_t i = 0; i < run.count; ++i) asked[i] = least[i] + share * (most[i] - least[i]);
  }
}

std::vector<double> limitedInValue(std::vector<double> wanted, const LoopSettings& settings) {
  for (double& amount : wanted) {
    if (!std::isfinite(amount)) amount = 0.0;
    amount = std::clamp(amount, settings.least_amount, settings.greatest_amount);
  }
  return wanted;
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
  correction.amount = limitedInValue(wanted, settings);
  const double change = volumeChange(cells, correction.amount);
  if (std::abs(change) > settings.layer_volume)
    for (double& amount : correction.amount) amount *= settings.layer_volume / std::abs(change);
  // A slope is no want that is not met: it is counted before.
  correction.limited_share = shareOfLength(cells, wanted, correction.amount);
  limitSlope(correction.amount, cells, settings.feeder_rate_s, SlopeLimit::SameVolume);
  return correction;
}

std::vector<double> followedCommands(const LayerCells& cells, const std::vector<double>& wanted,
                                     const LoopSettings& settings) {
  std::vector<double> commands = limitedInValue(wanted, settings);
  limitSlope(commands, cells, settings.feeder_rate_s, SlopeLimit::Midway);
  return commands;
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
  double last = from[begin > 0 ? begin - 1 : begin];  // where the nozzle comes from
  bool is_over = false;
  for (const CellRun& run : cells.runs) {
    is_over = is_over || (run.is_after_other && run.first >= begin);
    for (std::size_t i = std::max(begin, run.first); i < run.first + run.count; ++i) {
      const double step = greatestSlope(settings.feeder_rate_s, cells.speed_mm_s[i]) * run.cellLength();
      last = is_over ? to[i] : std::clamp(to[i], last - step, last + step);
      is_over = is_over || last == to[i];
      faded[i] = last;
    }
  }
  return faded;
}

}  // namespace lamina
