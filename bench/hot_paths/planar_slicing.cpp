// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Plane slicing and chaining alone, topology included, on one thread: time over triangles and over layers.
// Google Benchmark fits the exponents ("BigO" and the printed N^x of the last lines).
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "support/solids.hpp"

namespace {

using namespace lamina;

/// Sphere of 40 mm with bumps: r = 40 (1 + 0.12 sin 9 phi sin 7 theta sin^2 theta), about `triangles`
/// triangles.
Mesh bumpySphere(std::size_t triangles) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4.0)) + 1;
  return test::starShaped(rings, 2 * rings, [](double theta, double phi) {
    const double bump = std::sin(9.0 * phi) * std::sin(7.0 * theta) * std::sin(theta) * std::sin(theta);
    return 40.0 * (1.0 + 0.12 * bump);
  });
}

std::vector<double> planes(std::size_t count) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < count; ++i)
    heights.push_back(-40.0 + 80.0 * (static_cast<double>(i) + 0.5) / count);
  return heights;
}

void run(benchmark::State& state, std::size_t triangles, std::size_t layers) {
  const ThreadLimit one_thread(1);
  const Mesh mesh = bumpySphere(triangles);
  const std::vector<double> heights = planes(layers);
  NoProgress progress;
  for (auto _ : state) benchmark::DoNotOptimize(sliceMesh(mesh, heights, progress));
  state.SetComplexityN(state.range(0));
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void overTriangles(benchmark::State& state) { run(state, static_cast<std::size_t>(state.range(0)), 400); }
void overLayers(benchmark::State& state) { run(state, 100000, static_cast<std::size_t>(state.range(0))); }

BENCHMARK(overTriangles)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(overLayers)->Arg(400)->Arg(4000)->Arg(40000)->Unit(benchmark::kMillisecond);

/// The usual table, followed by the exponent b of time = a N^b for each family of runs, fitted by least
/// squares.
class ExponentReporter final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& one : runs)
      points_[one.run_name.function_name].emplace_back(std::log(static_cast<double>(one.complexity_n)),
                                                       std::log(one.GetAdjustedCPUTime()));
  }

  void Finalize() override {
    for (const auto& [name, points] : points_)
      GetOutputStream() << name << ": time grows with the power " << slope(points) << '\n';
  }

 private:
  using Points = std::vector<std::pair<double, double>>;

  static double slope(const Points& points) {
    double x_sum = 0.0, y_sum = 0.0, xx_sum = 0.0, xy_sum = 0.0;
    for (const auto& [x, y] : points) {
      x_sum += x;
      y_sum += y;
      xx_sum += x * x;
      xy_sum += x * y;
    }
    const auto count = static_cast<double>(points.size());
    return (count * xy_sum - x_sum * y_sum) / (count * xx_sum - x_sum * x_sum);
  }

  std::map<std::string, Points> points_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  ExponentReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
