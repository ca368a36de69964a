// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/feeder_lead.hpp"

#include <algorithm>

namespace lamina {

std::vector<double> timesOf(const LayerCells& cells) {
  std::vector<double> times(cells.size());
  double now_s = 0.0;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const double cell_s = run.cellLength() / cells.speed_mm_s[i];
      times[i] = now_s + 0.5 * cell_s;
      now_s += cell_s;
    }
  }
  return times;
}

std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const FeederDelay& feeder, const LoopSettings& settings) {
  if ((feeder.dead_time_s == 0.0 && feeder.lag_s == 0.0) || cells.size() == 0) return amount;
  const std::vector<double> times = timesOf(cells);
  std::vector<double> inverted = amount;
  for (std::size_t i = 0; i + 1 < amount.size() && feeder.lag_s > 0.0; ++i)
    inverted[i] += feeder.lag_s * (amount[i + 1] - amount[i]) / (times[i + 1] - times[i]);
  std::vector<double> led(amount.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < led.size(); ++i) {
    const double acts_s = times[i] + feeder.dead_time_s;
    while (k + 1 < led.size() && times[k + 1] <= acts_s) ++k;
    led[i] = inverted[k];
    if (k + 1 < led.size())
      led[i] +=
          (inverted[k + 1] - inverted[k]) * std::max(0.0, acts_s - times[k]) / (times[k + 1] - times[k]);
  }
  LoopSettings unbounded_volume = settings;
  unbounded_volume.layer_volume = amountRange(settings) + 1.0;  // the volume was bounded where it arrives
  return limitedCorrection(cells, std::move(led), unbounded_volume).amount;
}

}  // namespace lamina
