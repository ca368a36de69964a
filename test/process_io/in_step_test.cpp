// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Effects of devices with dead times and lags are in step with the motion: 500 steps over 2000 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

#include "lamina/process_io/devices/lagging_response.hpp"
#include "lamina/process_io/process_bridge.hpp"

namespace lamina {
namespace {

constexpr int kSteps = 500;
constexpr double kStepMm = 4.0;  // of 2000
constexpr double kSpeed = 10.0;  // mm/s
constexpr double kStepS = kStepMm / kSpeed;
constexpr double kPoint = 0.004;  // s between points, as a driver hands them over
constexpr double kChunk = 0.2;    // s
constexpr double kAhead = 1.0;    // s that chunks come before they begin
constexpr double kBegin = 2.003;  // s: the first step

struct Step {
  double laser_w = 0.0;
  double wire_mm_s = 0.0;
  double screw_rpm = 0.0;
};

std::vector<Step> randomSteps() {
  std::mt19937 random(20);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 8U) / static_cast<double>(1U << 24U);
  };
  std::vector<Step> steps;
  for (int i = 0; i < kSteps; ++i)
    steps.push_back({between(600.0, 1400.0), between(15.0, 45.0), between(10.0, 40.0)});
  return steps;
}

ProcessSignals signalsAt(double time_s, const std::vector<Step>& steps) {
  ProcessSignals signals;
  const double index = (time_s - kBegin) / kStepS;
  if (index < 0.0 || index >= kSteps) return signals;
  const Step& step = steps[static_cast<std::size_t>(index)];
  signals.flow_mm3_s = 10.0;
  signals.is_laser_on = signals.is_wire_fed = true;
  signals.levels[ProcessLevel::LaserPower] = step.laser_w;
  signals.levels[ProcessLevel::WireSpeed] = step.wire_mm_s;
  signals.levels[ProcessLevel::ScrewSpeed] = step.screw_rpm;
  return signals;
}

ProcessChunk chunkFrom(double time_s, const std::vector<Step>& steps) {
  ProcessChunk chunk;
  for (double at_s = time_s; at_s < time_s + kChunk + 0.5 * kPoint; at_s += kPoint)
    chunk.points.push_back({at_s, signalsAt(at_s + 1e-9, steps)});
  chunk.valid_until_s = chunk.points.back().time_s;
  return chunk;
}

OutputChannel channelOf(ProcessQuantity quantity, double high) {
  OutputChannel channel;
  channel.name = nameOf(quantity);
  channel.quantity = quantity;
  channel.high = high;
  return channel;
}

/// By how much each step's middle is crossed before or after it is planned [s], by channel.
std::vector<std::vector<double>> errorsWith(double dead_time_s, double lag_s) {
  const std::vector<Step> steps = randomSteps();
  ProcessTables tables;
  tables.channels = {channelOf(ProcessQuantity::LaserPower, 2000.0),
                     channelOf(ProcessQuantity::WireSpeed, 60.0),
                     channelOf(ProcessQuantity::ScrewSpeed, 60.0)};
  for (OutputChannel& channel : tables.channels) {
    channel.dead_time_s = dead_time_s;
    channel.lag_s = lag_s;
  }
  ProcessBridgeSettings settings;
  settings.standstill_s = 0.0;
  ProcessBridge bridge(tables, settings, 0.0);
  std::vector<LaggingResponse> devices(3, {dead_time_s, lag_s});
  std::vector<std::vector<double>> effects(3);  // at each millisecond
  double handed_s = 0.0;
  const int cycles = static_cast<int>((kBegin + kSteps * kStepS + 1.0) * settings.rate_hz);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double now_s = cycle / settings.rate_hz;
    for (; handed_s < now_s + kAhead; handed_s += kChunk) bridge.accept(chunkFrom(handed_s, steps), now_s);
    const BridgeCycle sent = bridge.cycle(now_s, {});
    EXPECT_EQ(sent.alarms.size(), 0U);
    for (std::size_t c = 0; c < 3; ++c) {
      devices[c].send(sent.values[c], now_s);
      for (int ms = 0; ms < 10; ++ms) effects[c].push_back(devices[c].effectAt(now_s + 1e-3 * ms));
    }
  }
  EXPECT_EQ(bridge.lateChunks() + bridge.overtaken(), 0U);
  std::vector<std::vector<double>> errors(3);
  for (int i = 1; i < kSteps; ++i) {
    const auto at = [&](int step, std::size_t c) {
      const Step& each = steps[static_cast<std::size_t>(step)];
      return c == 0 ? each.laser_w : c == 1 ? each.wire_mm_s : each.screw_rpm;
    };
    const int planned_ms = static_cast<int>(std::lround(1e3 * (kBegin + i * kStepS)));
    for (std::size_t c = 0; c < 3; ++c) {
      const double middle = 0.5 * (at(i - 1, c) + at(i, c));
      const bool rises = at(i, c) > at(i - 1, c);
      int crossed_ms = planned_ms - 190;
      while (crossed_ms < planned_ms + 200 &&
             (effects[c][static_cast<std::size_t>(crossed_ms)] < middle) == rises)
        ++crossed_ms;
      errors[c].push_back(1e-3 * (crossed_ms - planned_ms));
    }
  }
  return errors;
}

double percentile99(std::vector<double> errors) {
  for (double& error : errors) error = std::abs(error);
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() * 99 / 100];
}

TEST(ProcessInStep, TakesEffectWithTheMotionWhateverTheDelay) {
  for (const double dead_time_s : {0.0, 0.1, 0.5})
    for (const double lag_s : {0.0, 0.2}) {
      const auto errors = errorsWith(dead_time_s, lag_s);
      for (std::size_t c = 0; c < 3; ++c) {
        const double p99 = percentile99(errors[c]);
        std::printf("dead time %.1f s, lag %.1f s, channel %zu: 99 %% within %.1f ms\n", dead_time_s, lag_s,
                    c, 1e3 * p99);
        EXPECT_LE(p99, 0.010) << dead_time_s << ' ' << lag_s << ' ' << c;
      }
    }
}

}  // namespace
}  // namespace lamina
