// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Poses a second of arms, on one thread: all solutions of a pose, in closed form and by iteration.
#include <benchmark/benchmark.h>

#include "lamina/base/random.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"

namespace {

using namespace lamina;

constexpr int kPoses = 1000;

std::vector<JointValues> anyValues(const KinematicModel& arm) {
  Random random(1);
  std::vector<JointValues> values;
  while (values.size() < kPoses) values.push_back(test::anyJointValues(arm, random));
  return values;
}

void solve(benchmark::State& state, const KinematicModel& arm) {
  const std::vector<JointValues> near = anyValues(arm);
  std::vector<Eigen::Isometry3d> wanted;
  for (const JointValues& values : near) wanted.push_back(arm.bedFromNozzle(values));
  std::size_t pose = 0;
  std::size_t found = 0;
  for (auto _ : state) {
    found += arm.solutions(wanted[pose], near[pose]).size();
    pose = (pose + 1) % wanted.size();
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["poses/s"] = benchmark::Counter(runs, benchmark::Counter::kIsRate);
  state.counters["solutions"] = static_cast<double>(found) / runs;
}

void sphericalWrist(benchmark::State& state) { solve(state, *kinematicModelByName("irb_4600")); }
void withTurntable(benchmark::State& state) { solve(state, *kinematicModelByName("irb_4600_turntable")); }
void roundedDescription(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::roundedArm().urdf()));
}
void parallelAxes(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::exactParallelAxesArm().urdf()));
}
void roundedParallelAxes(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::parallelAxesArm().urdf()));
}
void asideWrist(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::asideWristArm().urdf()));
}
void raisedWrist(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::raisedWristArm().urdf()));
}
void sphericalSeven(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::sphericalSeven().urdf()));
}
void offsetSeven(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::offsetSeven().urdf()));
}
void noClass(benchmark::State& state) {
  solve(state, *kinematicModelFromUrdf(test::scatteredWristArm().urdf()));
}

BENCHMARK(sphericalWrist);
BENCHMARK(withTurntable);
BENCHMARK(roundedDescription);
BENCHMARK(parallelAxes);
BENCHMARK(roundedParallelAxes);
BENCHMARK(asideWrist);
BENCHMARK(raisedWrist);
BENCHMARK(sphericalSeven);
BENCHMARK(offsetSeven);
BENCHMARK(noClass)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
