// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Leading an arm along a spiral of steep walls: seconds over the number of waypoints, with 72 turns about the
// tool axis at each; and the most memory that the process ever had.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <string>

#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"

namespace {

using namespace lamina;

/// A spiral of 60 mm radius, 0.5 mm from waypoint to waypoint, its tool axis inclined outwards by 20 deg.
Toolpath spiral(std::size_t waypoints) {
  constexpr double kRadius = 60.0;
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 20.0;
  path.bead = Bead{2.0, 0.5};
  std::vector<Eigen::Quaterniond> nozzles;
  for (std::size_t i = 0; i < waypoints; ++i) {
    const double at = 0.5 / kRadius * static_cast<double>(i);
    const Point3 outwards(std::cos(at), std::sin(at), 0.0);
    path.points.push_back(kRadius * outwards + Point3(0, 0, 0.5 * at / (2.0 * M_PI)));
    const Eigen::AngleAxisd tilt(20.0 * M_PI / 180.0, outwards.cross(Point3::UnitZ()));
    nozzles.emplace_back(tilt * nozzleDown());
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  Toolpath toolpath;
  toolpath.layers.push_back({0.5, 0.5, {std::move(path)}});
  return toolpath;
}

double mostMemoryMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void plan(benchmark::State& state, const KinematicModel& model, const JointPathSettings& settings) {
  const Toolpath toolpath = spiral(static_cast<std::size_t>(state.range(0)));
  NoProgress progress;
  std::size_t faults = 0;
  for (auto _ : state) {
    const JointPath path = planJointPath(toolpath, Eigen::Isometry3d::Identity(), model, settings, progress);
    faults = path.faults.size();
    benchmark::DoNotOptimize(path.values.data());
  }
  state.counters["faults"] = static_cast<double>(faults);
  state.counters["MB"] = mostMemoryMb();
}

void onArm(benchmark::State& state) { plan(state, *kinematicModelByName("irb_4600"), JointPathSettings()); }

/// Over a plate that tilts and turns so that the nozzle points down; run from the root of the sources.
void onPositioner(benchmark::State& state) {
  JointPathSettings settings;
  settings.external = ExternalChoice::Gravity;
  const std::string urdf = readMachineDescription("examples/robots/tilting_cell/cell.yaml");
  plan(state, *kinematicModelFromUrdf(urdf), settings);
}

/// Over numbers of waypoints, by the processor time of all threads.
void overWaypoints(benchmark::internal::Benchmark* bench) {
  bench->Arg(1000)->Arg(10000)->Arg(100000);
  bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

}  // namespace

BENCHMARK(onArm)->Apply(overWaypoints);
BENCHMARK(onPositioner)->Apply(overWaypoints);
BENCHMARK_MAIN();
