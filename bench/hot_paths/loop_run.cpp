// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop on layer heights over a recorded print: times faster than it was printed, and memory over an hour
// of it.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <fstream>
#include <memory>

#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

constexpr double kSpeed = 20.0;             // mm/s
constexpr double kLength = 200.0;           // mm
constexpr double kLayer = 1.5;              // mm
constexpr int kPoints = 300;                // of a profile
constexpr double kWidth = 30.0;             // mm, of a profile
constexpr std::int64_t kStep = 10'000'000;  // ns from pose to pose and profile to profile

double residentMb() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// A profile across the wall, and of the bed beside it.
std::vector<Point3> profileAt(double above_mm, double top_mm) {
  std::vector<Point3> points;
  points.reserve(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double y = kWidth * (static_cast<double>(i) / kPoints - 0.5);
    const double height = std::abs(y) < 1.5 ? top_mm : 0.0;
    points.emplace_back(y, 0.0, above_mm + 60.0 - height);
  }
  return points;
}

/// Says what a cell says over a print; heights are those of a feeder that gives 0.95.
double printTo(LoopRun& run, std::size_t layers) {
  std::int64_t now_ns = 1'000'000'000'000;
  const auto step_mm = kSpeed * static_cast<double>(kStep) / 1e9;
  for (std::size_t k = 0; k < layers; ++k) {
    const double z = kLayer * static_cast<double>(k + 1);
    const double top = z - 0.05;
    for (double x = 0.0; x < kLength; x += step_mm) run.observe({now_ns += kStep, {x, 0, z}});
    run.observe({now_ns += kStep, {kLength, 0, z}});
    run.observe({now_ns += kStep, {kLength, 0, z + 5.0}});
    for (double x = kLength; x > 0.0; x -= 2.0 * step_mm) {
      const Point3 tip(x, 0, z + 5.0);
      run.observe({now_ns += kStep, tip});
      SensedCloud cloud;
      cloud.stamp_ns = now_ns;
      cloud.bed_from_sensor = test::sensorOver(tip);
      cloud.profiles.push_back(profileAt(tip.z(), top));
      run.see(std::move(cloud));
    }
    run.observe({now_ns += kStep, {0, 0, z + 5.0}});
    benchmark::DoNotOptimize(run.takeNews());
  }
  run.finish();
  return static_cast<double>(now_ns - 1'000'000'000'000) / 1e9;
}

void loopOverAPrint(benchmark::State& state) {
  test::SensedWallCase wall;
  wall.length_mm = kLength;
  wall.layers = static_cast<std::size_t>(state.range(0));
  PlacedPart part;
  part.toolpath = test::scannedWall(wall);
  part.toolpath_id = toolpathId(part.toolpath);
  double recorded_s = 0.0;
  double grown_mb = 0.0;
  for (auto _ : state) {
    LoopRun run(part, test::calibratedLoop());
    const double before_mb = residentMb();
    recorded_s += printTo(run, wall.layers);
    grown_mb = residentMb() - before_mb;
  }
  state.counters["times_real_time"] = benchmark::Counter(recorded_s, benchmark::Counter::kIsRate);
  state.counters["recorded_s"] = recorded_s / static_cast<double>(state.iterations());
  state.counters["grown_mb"] = grown_mb;
}
BENCHMARK(loopOverAPrint)->Arg(24)->Arg(240)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
