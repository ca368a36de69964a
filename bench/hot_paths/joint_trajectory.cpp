// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Timing of a joint path, on one thread: time over the number of waypoints. The path is a spiral of waypoints
// 0.5 mm apart that six joints follow; every joint moves along all of it. Sampling is what a controller at
// 250 Hz asks.
#include <benchmark/benchmark.h>

#include <cmath>

#include "support/joint_paths.hpp"

#include "lamina/trajectory/timed_path.hpp"

namespace {

using namespace lamina;

constexpr double kSpacing = 0.5;  // mm
constexpr double kPitch = 2.0;    // mm

/// Three linear axes with a rotary one in the middle of each, which do nothing to the tip.
class SixJoints final : public test::HandMadeModel {
 public:
  SixJoints()
      : HandMadeModel({{"x", JointKind::Linear, -1e4, 1e4, 200.0},
                       {"y", JointKind::Linear, -1e4, 1e4, 200.0},
                       {"z", JointKind::Linear, -1e4, 1e4, 50.0},
                       {"a", JointKind::Rotary, -9.0, 9.0, 3.0},
                       {"b", JointKind::Rotary, -9.0, 9.0, 3.0},
                       {"c", JointKind::Rotary, -9.0, 9.0, 3.0}}) {}
  Eigen::Isometry3d bedFromNozzle(const JointValues& q) const override {
    Eigen::Isometry3d pose(nozzleDown());
    pose.translation() = q.head<3>();
    return pose;
  }
  Jacobian jacobian(const JointValues& /*values*/) const override {
    Jacobian j = Jacobian::Zero(6, 6);
    j.topLeftCorner<3, 3>().setIdentity();
    return j;
  }
};

Toolpath spiral(std::size_t waypoints) {
  Path path;
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  double angle = 2.0 * M_PI;
  for (std::size_t i = 0; i < waypoints; ++i) {
    const double radius = kPitch * angle / (2.0 * M_PI);
    path.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1e-4 * radius);
    angle += kSpacing / radius;
  }
  return {"spiral", {{0.2, 0.2, {path}}}};
}

struct Job {
  SixJoints model;
  Toolpath toolpath;
  JointPath path;
  TimingSettings settings;

  explicit Job(std::size_t waypoints) : toolpath(spiral(waypoints)) {
    path = test::jointPathBy(toolpath, [](const Point3& tip) {
      JointValues q(6);
      q << tip, 0.5 * std::sin(0.05 * tip.x()), 0.5 * std::sin(0.05 * tip.y()), 0.01 * tip.x();
      return q;
    });
  }
};

void time(benchmark::State& state) {
  Job job(static_cast<std::size_t>(state.range(0)));
  job.settings.trajectory.jerk_ramp_s = 1e-3 * static_cast<double>(state.range(1));
  double print_s = 0.0;
  for (auto _ : state) print_s = TimedPath(job.toolpath, job.path, job.model, job.settings).duration();
  state.counters["print_s"] = print_s;
  state.SetComplexityN(state.range(0));
}

void sample(benchmark::State& state) {
  Job job(static_cast<std::size_t>(state.range(0)));
  job.settings.trajectory.jerk_ramp_s = 1e-3 * static_cast<double>(state.range(1));
  const TimedPath timed(job.toolpath, job.path, job.model, job.settings);
  double time_s = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(timed.at(time_s).position.data());
    time_s = time_s > timed.duration() ? 0.0 : time_s + 0.004;
  }
}

BENCHMARK(time)
    ->ArgsProduct({{1000, 10000, 100000}, {0, 10}})
    ->ArgNames({"waypoints", "jerk_ramp_ms"})
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(sample)->ArgsProduct({{100000}, {0, 10}})->ArgNames({"waypoints", "jerk_ramp_ms"});

}  // namespace

BENCHMARK_MAIN();
