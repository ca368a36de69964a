// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Under- and overfill of a surface: a sphere of 10 000 faces with 100 000 segments right below its surface,
// and the six faces of a box of 20 x 40 x 20 mm that 200 m of path fill, layer by layer.
#include <benchmark/benchmark.h>

#include <cmath>

#include "lamina/geometry/parts/parts.hpp"
#include "lamina/metrics/surface_fill.hpp"

namespace lamina {
namespace {

constexpr Bead kBead{0.4, 0.2};

Path beadThrough(std::vector<Point3> points) {
  Path path;
  path.points = std::move(points);
  path.bead = kBead;
  path.feed_mm_s = 50.0;
  return path;
}

/// A spiral from pole to pole of a sphere that stands on the bed.
Toolpath spiral(double radius, int segments) {
  std::vector<Point3> points;
  const double turns = M_PI * radius / 0.3;
  for (int i = 0; i <= segments; ++i) {
    const double polar = M_PI * i / segments;
    const double around = 2.0 * M_PI * turns * i / segments;
    points.emplace_back(Point3(0, 0, radius) + (radius - 0.1) * Point3(std::sin(polar) * std::cos(around),
                                                                       std::sin(polar) * std::sin(around),
                                                                       std::cos(polar)));
  }
  return {"spiral", {{2.0 * radius, 0.2, {beadThrough(points)}}}};
}

/// Rectangles within each other in every layer, each run in pieces of some length.
Toolpath filledBox(double piece_mm) {
  Toolpath toolpath{"box", {}};
  for (int l = 1; l <= 100; ++l) {
    ToolpathLayer layer{0.2 * l, 0.2, {}};
    for (double inset = 0.2; inset < 10.0; inset += 0.4) {
      const Point3 to(10.0 - inset, 20.0 - inset, 0.2 * l);
      const Point3 corners[] = {{-to.x(), -to.y(), to.z()},
                                {to.x(), -to.y(), to.z()},
                                to,
                                {-to.x(), to.y(), to.z()},
                                {-to.x(), -to.y(), to.z()}};
      std::vector<Point3> points{corners[0]};
      for (int c = 0; c < 4; ++c) {
        const int parts = std::max(1, int((corners[c + 1] - corners[c]).norm() / piece_mm));
        // A hair's breadth to and fro, so that pieces do not become one.
        for (int p = 1; p <= parts; ++p)
          points.emplace_back(corners[c] + (corners[c + 1] - corners[c]) * (double(p) / parts) +
                              (p < parts ? 1e-3 * (p % 2) : 0.0) * Point3(1, 1, 0));
      }
      layer.paths.push_back(beadThrough(points));
    }
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

void measure(benchmark::State& state, const Toolpath& toolpath, const Mesh& part) {
  NoProgress nobody;
  SurfaceFill fill;
  for (auto _ : state) {
    fill = measureSurfaceFill(toolpath, part, Eigen::Isometry3d::Identity(), {}, nobody);
    benchmark::DoNotOptimize(fill);
  }
  state.counters["faces"] = double(part.triangles.size());
  state.counters["waypoints"] = double(totals(toolpath).waypoints);
  state.counters["under_mm2"] = fill.under_fill_mm2;
  state.counters["over_mm2"] = fill.over_fill_mm2;
}

void sphere(benchmark::State& state) {
  const double radius = double(state.range(0));
  const Mesh part = makePart("sphere", {{"radius_mm", std::to_string(radius)}, {"segments", "100"}});
  measure(state, spiral(radius, 100000), part);
}

void box(benchmark::State& state) {
  const Mesh part = makePart("box", {{"x_mm", "20"}, {"y_mm", "40"}, {"z_mm", "20"}});
  measure(state, filledBox(double(state.range(0)) / 10.0), part);
}

BENCHMARK(sphere)->Arg(7)->Arg(50)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(box)->Arg(1000)->Arg(5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace lamina

BENCHMARK_MAIN();
