// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/clock_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lamina {
namespace {

constexpr std::size_t kCompared = 16;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

ClockOffset offsetOf(const ClockExchange& exchange) {
  const double there = exchange.received_s - exchange.asked_s;
  const double back = exchange.answered_s - exchange.heard_s;
  const double round_trip =
      (exchange.heard_s - exchange.asked_s) - (exchange.answered_s - exchange.received_s);
  return {(there + back) / 2.0, round_trip / 2.0};
}

void ClockComparison::add(const ClockExchange& exchange) {
  const ClockOffset found = offsetOf(exchange);
  const bool is_plausible = std::isfinite(found.offset_s) && found.uncertainty_s >= 0.0 &&
                            exchange.answered_s >= exchange.received_s;
  if (!is_plausible) return;
  last_.push_back(found);
  if (last_.size() > kCompared) last_.pop_front();
}

std::optional<ClockOffset> ClockComparison::offset() const {
  if (last_.size() < kCompared) return std::nullopt;
  std::vector<double> offsets;
  std::vector<double> uncertainties;
  for (const ClockOffset& each : last_) {
    offsets.push_back(each.offset_s);
    uncertainties.push_back(each.uncertainty_s);
  }
  return ClockOffset{median(std::move(offsets)), median(std::move(uncertainties))};
}

}  // namespace lamina
