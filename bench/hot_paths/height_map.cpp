// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Fusing 90 000 measured points at 0.5 mm, against OctoMap's insertion of the same points; a profile of the
// simulated sensor; and a layer of beads deposited into a map.
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/deposition/bead_deposit.hpp"
#include "lamina/monitoring/measured_surface.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

constexpr int kPoints = 90000;
constexpr double kCell = 0.5;    // mm
constexpr double kSide = 100.0;  // mm

std::vector<Point3> wavyPoints() {
  Random random(5);
  std::vector<Point3> points;
  for (int i = 0; i < kPoints; ++i) {
    const Point2 at(random.uniform(0, kSide), random.uniform(0, kSide));
    points.emplace_back(at.x(), at.y(), 3.0 * std::sin(0.1 * at.x()) + 2.0 * std::cos(0.15 * at.y()));
  }
  return points;
}

HeightGrid grid(double cell) { return heightGrid({Point2(0, 0), Point2(kSide, kSide)}, cell); }

void fuseHeights(benchmark::State& state) {
  const auto points = wavyPoints();
  for (auto _ : state) {
    MeasuredSurface surface(grid(kCell));
    for (const Point3& point : points) surface.insert(point);
    benchmark::DoNotOptimize(surface.height(0));
  }
  state.SetItemsProcessed(state.iterations() * kPoints);
}
BENCHMARK(fuseHeights)->Unit(benchmark::kMillisecond);

void insertPointCloud(benchmark::State& state) {
  octomap::Pointcloud cloud;
  for (const Point3& point : wavyPoints())
    cloud.push_back(float(point.x()), float(point.y()), float(point.z()));
  const octomap::point3d sensor(50.0F, 50.0F, 60.0F);
  for (auto _ : state) {
    octomap::OcTree tree(kCell);
    tree.insertPointCloud(cloud, sensor);
    benchmark::DoNotOptimize(tree.size());
  }
  state.SetItemsProcessed(state.iterations() * kPoints);
}
BENCHMARK(insertPointCloud)->Unit(benchmark::kMillisecond);

void insertEndPointsIntoOctree(benchmark::State& state) {
  const auto points = wavyPoints();
  for (auto _ : state) {
    octomap::OcTree tree(kCell);
    for (const Point3& point : points) tree.updateNode(point.x(), point.y(), point.z(), true, true);
    tree.updateInnerOccupancy();
    benchmark::DoNotOptimize(tree.size());
  }
  state.SetItemsProcessed(state.iterations() * kPoints);
}
BENCHMARK(insertEndPointsIntoOctree)->Unit(benchmark::kMillisecond);

void measureProfile(benchmark::State& state) {
  const HeightMap plate(grid(0.2), 2.0);
  ProfileSensor sensor{ProfileSensorSettings{}};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Point3(50, 50, 62);
  pose.linear() = Eigen::AngleAxisd(M_PI, Point3::UnitX()).toRotationMatrix();
  for (auto _ : state) benchmark::DoNotOptimize(sensor.measure(plate, pose));
}
BENCHMARK(measureProfile)->Unit(benchmark::kMicrosecond);

/// A filled square of 40 mm in motions of the given length [µm].
void depositLayer(benchmark::State& state) {
  const double step = 1e-3 * static_cast<double>(state.range(0));
  const double section = crossSection({0.4, 0.2});
  double length = 0.0;
  for (auto _ : state) {
    BeadDeposit deposit(HeightMap(grid(0.1), 0.0));
    for (double y = 30.0; y < 70.0; y += 0.4)
      for (double x = 30.0; x < 70.0 - 0.5 * step; x += step, length += step)
        deposit.lay({{x, y, 0.2}, {x + step, y, 0.2}, step * section});
    benchmark::DoNotOptimize(deposit.surface().at(0));
  }
  state.counters["mm/s"] = benchmark::Counter(length, benchmark::Counter::kIsRate);
}
BENCHMARK(depositLayer)->Arg(500)->Arg(4000)->Arg(40000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
