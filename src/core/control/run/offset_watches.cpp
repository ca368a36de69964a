// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/offset_watches.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kLeastOffsetSigma = 0.001;  // s, better than which no stamps are

}  // namespace

double SensorOffset::sigmas() const {
  return left.sigma_s > 0.0 ? std::abs(left.offset_s) / left.sigma_s : 0.0;
}

void OffsetWatches::begin(std::size_t cells) {
  cells_ = cells;
  watches_.clear();
}

void OffsetWatches::see(const std::string& sensor, std::size_t cell, double speed_mm_s,
                        const CellReading& reading) {
  const auto [watch, is_new] = watches_.try_emplace(sensor);
  if (is_new) watch->second.begin(cells_);
  watch->second.see(cell, speed_mm_s, reading);
}

std::optional<SensorOffset> OffsetWatches::offset(const LayerCells& cells,
                                                  const TimeOffsetSigmas& calibrated) const {
  std::optional<SensorOffset> worst;
  for (const auto& [sensor, watch] : watches_) {
    const auto left = watch.offset(cells);
    if (!left) continue;
    const double sigma_s = std::hypot(left->sigma_s, calibrated.of(sensor), kLeastOffsetSigma);
    const SensorOffset offset{sensor, {left->offset_s, sigma_s}};
    if (!worst || offset.sigmas() > worst->sigmas()) worst = offset;
  }
  return worst;
}

void judge(const SensorOffset& offset, SensorWatch& seen) {
  seen.time_offset_s = offset.left.offset_s;
  seen.time_offset_sigmas = offset.sigmas();
  seen.offset_sensor = offset.sensor;
}

}  // namespace lamina
