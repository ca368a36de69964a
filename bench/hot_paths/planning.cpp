// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The parts of planning one layer, and whole plans over the number of layers, on one thread.
#include <benchmark/benchmark.h>

#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/planner.hpp"

namespace {

using namespace lamina;

Polygon wavyCircle(const Point2& centre, double radius, int points) {
  Polygon polygon;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * M_PI * i / points;
    const double r = radius * (1.0 + 0.05 * std::sin(9.0 * angle));
    polygon.emplace_back(centre + r * Point2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// A wavy disc of 60 mm with four wavy holes of 10 mm, of `points` points altogether.
std::vector<Polygon> section(int points) {
  std::vector<Polygon> contours = {wavyCircle({0, 0}, 30.0, points / 2)};
  for (const Point2& centre : {Point2(12, 0), Point2(0, 12), Point2(-12, 0), Point2(0, -12)}) {
    const Polygon hole = wavyCircle(centre, 5.0, points / 8);
    contours.emplace_back(hole.rbegin(), hole.rend());
  }
  return contours;
}

/// A wall too thin for two beads in the middle: its moved outlines meet, so that they must be clipped.
Regions necked(int points) {
  Polygon polygon;
  for (int i = 0; i < points / 2; ++i) {
    const double x = 40.0 * i / points - 10.0;
    polygon.emplace_back(x, -0.1 - 0.01 * x * x);
  }
  for (int i = points / 2; i > 0; --i) {
    const double x = 40.0 * i / points - 10.0;
    polygon.emplace_back(x, 0.1 + 0.01 * x * x);
  }
  return {{polygon, {}}};
}

int pointsOf(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

void Simplify(benchmark::State& state) {
  const std::vector<Polygon> contours = section(pointsOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(simplify(contours, 0.01));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(Simplify)->RangeMultiplier(8)->Range(64, 32768)->Complexity();

void Unite(benchmark::State& state) {
  const std::vector<Polygon> contours = section(pointsOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(unite(contours));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(Unite)->RangeMultiplier(8)->Range(64, 32768)->Complexity();

void EdgeCollapse(benchmark::State& state) {
  const Regions regions = unite(section(pointsOf(state)));
  for (auto _ : state) benchmark::DoNotOptimize(offset(regions, -0.2));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(EdgeCollapse)->RangeMultiplier(8)->Range(64, 32768)->Complexity();

void ShrinkByClipping(benchmark::State& state) {
  const Regions regions = necked(pointsOf(state));
  for (auto _ : state) benchmark::DoNotOptimize(offset(regions, -0.2));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(ShrinkByClipping)->RangeMultiplier(8)->Range(64, 4096)->Complexity();

void Zigzag(benchmark::State& state) {
  const Regions regions = unite(section(512));
  const InfillStrategy fill = infillStrategy("zigzag");
  InfillRequest request;
  request.spacing_mm = 60.0 / static_cast<double>(state.range(0));
  request.angle_rad = 0.7;
  for (auto _ : state) benchmark::DoNotOptimize(fill.fill(regions, request));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(Zigzag)->RangeMultiplier(4)->Range(8, 2048)->Complexity();

/// A sparse layer of a disc, of lines 60 / n mm apart.
void SparseFill(benchmark::State& state, const char* name) {
  const Regions regions = unite(section(512));
  const InfillStrategy fill = infillStrategy(name);
  InfillRequest request;
  request.spacing_mm = 60.0 / static_cast<double>(state.range(0));
  request.pitch_mm = 0.357;
  request.angle_rad = 0.7;
  request.part_from_plan = Eigen::Translation3d(0.0, 0.0, 7.3);
  for (auto _ : state) benchmark::DoNotOptimize(fill.fill(regions, request));
}
BENCHMARK_CAPTURE(SparseFill, zigzag, "zigzag")->RangeMultiplier(4)->Range(8, 128);
BENCHMARK_CAPTURE(SparseFill, grid, "grid")->RangeMultiplier(4)->Range(8, 128);
BENCHMARK_CAPTURE(SparseFill, cubic, "cubic")->RangeMultiplier(4)->Range(8, 128);
BENCHMARK_CAPTURE(SparseFill, honeycomb, "honeycomb")->RangeMultiplier(4)->Range(8, 128);
BENCHMARK_CAPTURE(SparseFill, gyroid, "gyroid")->RangeMultiplier(4)->Range(8, 128);

/// A plate with round holes of 2 mm in a square grid, 4 mm apart, with n holes along each side.
std::vector<Polygon> perforatedPlate(int n) {
  const double side = 4.0 * n;
  std::vector<Polygon> contours = {{{0, 0}, {side, 0}, {side, side}, {0, side}}};
  contours.reserve(1 + static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      Polygon& hole = contours.emplace_back();
      hole.reserve(32);
      for (int i = 0; i < 32; ++i) {
        const double angle = -2.0 * M_PI * i / 32;
        hole.emplace_back(4.0 * column + 2.0 + std::cos(angle), 4.0 * row + 2.0 + std::sin(angle));
      }
    }
  return contours;
}

/// Layers of a solid plate whose area grows with its holes: four times the holes are four times the work.
void PlanHoles(benchmark::State& state, const char* strategy) {
  const ThreadLimit one_thread(1);
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
  std::vector<Layer> layers;
  layers.reserve(4);
  for (int i = 0; i < 4; ++i) layers.push_back({{0.2 * i, 0.2 * (i + 1)}, {perforatedPlate(side), {}}});
  PlanSettings settings;
  settings.infill.strategy = strategy;
  settings.infill.density = 1.0;
  NoProgress progress;
  for (auto _ : state) benchmark::DoNotOptimize(planToolpath("plate", layers, settings, progress));
  state.SetComplexityN(state.range(0));
}
BENCHMARK_CAPTURE(PlanHoles, zigzag, "zigzag")->Arg(36)->Arg(144)->Arg(576)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(PlanHoles, contour, "contour")->Arg(36)->Arg(144)->Arg(576)->Unit(benchmark::kMillisecond);

void PlanLayers(benchmark::State& state) {
  const ThreadLimit one_thread(1);
  std::vector<Layer> layers;
  for (int i = 0; i < pointsOf(state); ++i) layers.push_back({{0.2 * i, 0.2 * (i + 1)}, {section(1024), {}}});
  NoProgress progress;
  for (auto _ : state) benchmark::DoNotOptimize(planToolpath("part", layers, PlanSettings{}, progress));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(PlanLayers)->RangeMultiplier(4)->Range(16, 256)->Complexity()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
