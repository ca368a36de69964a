// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading a cloud of 90 000 points over 250 x 250 mm into cells of 0.5 mm: level, inclined and curved layers,
// against OctoMap's insertion of the same points; and the correction of a layer of a million cells.
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

constexpr int kRows = 300;
constexpr int kPoints = 300;     // of a row
constexpr double kSide = 250.0;  // mm
constexpr double kCell = 0.5;    // mm
constexpr double kRadius = 400.0;

/// A raster of beads over a square about the origin, turned about x, or bent over a sphere.
struct Raster {
  double angle_deg = 0.0;
  bool is_bent = false;

  Eigen::Quaterniond turn() const {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle_deg * M_PI / 180.0, Eigen::Vector3d::UnitX()));
  }
  Eigen::Vector3d growth(double x, double y) const {
    return is_bent ? Eigen::Vector3d(x, y, kRadius).normalized() : turn() * Eigen::Vector3d::UnitZ();
  }
  Point3 point(double x, double y, double height) const {
    return is_bent ? Point3((kRadius + height) * growth(x, y)) : Point3(turn() * Point3(x, y, height));
  }
};

ToolpathLayer rasterLayer(const Raster& raster, const Bead& bead, std::size_t number) {
  const double top = static_cast<double>(number + 1) * bead.height_mm;
  ToolpathLayer layer{top, bead.height_mm, {}};
  const double step = raster.is_bent ? 2.0 : kSide;
  for (double y = -0.5 * (kSide - bead.width_mm); y < 0.5 * kSide; y += bead.width_mm) {
    Path path;
    path.bead = bead;
    path.feed_mm_s = 10.0;
    std::vector<Eigen::Quaterniond> held;
    for (double x = -0.5 * kSide; x <= 0.5 * kSide; x += step) {
      path.points.push_back(raster.point(x, y, top));
      held.push_back(shortestRotation(Eigen::Vector3d::UnitZ(), -raster.growth(x, y)));
    }
    path.orientation = AlongPath<Eigen::Quaterniond>(std::move(held));
    layer.paths.push_back(std::move(path));
  }
  return layer;
}

LayerCells rasterCells(const Raster& raster, const Bead& bead, std::size_t number) {
  const Eigen::Vector3d normal = raster.turn() * Eigen::Vector3d::UnitZ();
  return layerCells(rasterLayer(raster, bead, number), number, kCell, normal);
}

/// Rows of a patch that a sensor sees from 300 mm above, with noise.
std::vector<SensorProfile> patchOver(const Raster& raster, const Bead& bead) {
  Random random(5);
  SensorProfile row;
  const Eigen::Vector3d view = -raster.growth(0.0, 0.0);
  row.toolpath_from_sensor.linear() << raster.turn() * Eigen::Vector3d::UnitY(),
      view.cross(raster.turn() * Eigen::Vector3d::UnitY()), view;
  row.toolpath_from_sensor.translation() = raster.point(0.0, 0.0, 0.0) - 300.0 * view;
  const Eigen::Isometry3d sensor_from_toolpath = row.toolpath_from_sensor.inverse();
  std::vector<SensorProfile> rows;
  for (int r = 0; r < kRows; ++r) {
    const double x = kSide * ((r + 0.5) / kRows - 0.5);
    row.points.clear();
    for (int k = 0; k < kPoints; ++k) {
      const double y = kSide * ((k + 0.5) / kPoints - 0.5);
      const double height = 2.0 * bead.height_mm + random.normal(0.0, 0.02);
      row.points.push_back(sensor_from_toolpath * raster.point(x, y, height));
    }
    rows.push_back(row);
  }
  return rows;
}

Bead beadOf(const benchmark::State& state) {
  const double width = 1e-3 * static_cast<double>(state.range(0));
  return {width, 0.5 * width};
}

/// What comes with each cloud: its points to readings of the newest layer and the one below, and these to
/// the estimates of the cells.
void readPatch(benchmark::State& state, const Raster& raster) {
  const Bead bead = beadOf(state);
  CellAtlas atlas;
  std::vector<std::vector<CellEstimate>> fresh;
  std::size_t cells = 0;
  for (const std::size_t k : {0U, 1U}) {
    atlas.add(std::make_shared<const LayerCells>(rasterCells(raster, bead, k)));
    fresh.emplace_back(atlas.cellsOf(k)->size(), CellEstimate(0.0, 0.05, 1.0));
    cells += fresh.back().size();
  }
  const auto rows = patchOver(raster, bead);
  PointCounts counts;
  for (auto _ : state) {
    state.PauseTiming();
    auto estimates = fresh;
    const std::vector<LayerPrediction> predictions{{0, &estimates[0]}, {1, &estimates[1]}};
    counts = {};
    state.ResumeTiming();
    for (const SensorProfile& row : rows) {
      const ProfileReadings read = readProfile(row, atlas, predictions, {});
      for (const LayerReading& one : read.readings) estimates[one.layer][one.cell].see(one.reading, 0.2);
      counts += read.counts;
    }
    benchmark::DoNotOptimize(estimates[1].front());
  }
  state.counters["cells"] = static_cast<double>(cells);
  state.counters["used"] = static_cast<double>(counts.used);
  state.counters["index_MB"] = 1e-6 * static_cast<double>(atlas.bytes());
  state.counters["estimates_MB"] = 1e-6 * static_cast<double>(cells * sizeof(CellEstimate));
  state.SetItemsProcessed(state.iterations() * kRows * kPoints);
}

void readLevel(benchmark::State& state) { readPatch(state, {}); }
void readInclined(benchmark::State& state) { readPatch(state, {45.0, false}); }
void readCurved(benchmark::State& state) { readPatch(state, {0.0, true}); }
BENCHMARK(readLevel)->Arg(500)->Arg(1200)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK(readInclined)->Arg(500)->Arg(1200)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK(readCurved)->Arg(500)->Arg(1200)->Arg(3000)->Unit(benchmark::kMillisecond);

void insertIntoOctoMap(benchmark::State& state) {
  const Bead bead = beadOf(state);
  octomap::Pointcloud cloud;
  for (const SensorProfile& row : patchOver({}, bead)) {
    for (const Point3& seen : row.points) {
      const Point3 point = row.toolpath_from_sensor * seen;
      cloud.push_back(float(point.x()), float(point.y()), float(point.z()));
    }
  }
  std::size_t bytes = 0;
  for (auto _ : state) {
    octomap::OcTree tree(kCell);
    tree.insertPointCloud(cloud, octomap::point3d(0.0F, 0.0F, 300.0F));
    bytes = tree.memoryUsage();
  }
  state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
  state.SetItemsProcessed(state.iterations() * kRows * kPoints);
}
BENCHMARK(insertIntoOctoMap)->Arg(500)->Unit(benchmark::kMillisecond)->Iterations(1);

void addLayerToAtlas(benchmark::State& state, const Raster& raster) {
  const auto cells = std::make_shared<const LayerCells>(rasterCells(raster, beadOf(state), 0));
  for (auto _ : state) {
    CellAtlas atlas;
    atlas.add(cells);
    benchmark::DoNotOptimize(atlas.bytes());
  }
}
void addPlaneLayer(benchmark::State& state) { addLayerToAtlas(state, {}); }
void addCurvedLayer(benchmark::State& state) { addLayerToAtlas(state, {0.0, true}); }
BENCHMARK(addPlaneLayer)->Arg(500)->Arg(3000)->Unit(benchmark::kMillisecond);
BENCHMARK(addCurvedLayer)->Arg(500)->Arg(3000)->Unit(benchmark::kMillisecond);

/// A million cells: beads 3 mm wide, side by side over 1.5 km.
void correctLayer(benchmark::State& state) {
  ToolpathLayer layer{1.5, 1.5, {}};
  for (int bead = 0; bead < 1000; ++bead) {
    Path path;
    path.bead = Bead{3.0, 1.5};
    path.feed_mm_s = 10.0;
    path.points = {{0.0, 3.0 * bead, 1.5}, {500.0, 3.0 * bead, 1.5}};
    layer.paths.push_back(path);
  }
  const LayerCells cells = layerCells(layer, 0, kCell);
  Random random(7);
  LayerKnowledge known;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    known.error_mm.push_back(random.normal(0.0, 0.2));
    known.gain.push_back(random.uniform(0.9, 1.1));
  }
  for (auto _ : state) benchmark::DoNotOptimize(freeCorrection(cells, known, {}).amount.front());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cells.size()));
}
BENCHMARK(correctLayer)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
