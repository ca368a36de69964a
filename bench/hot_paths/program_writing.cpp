// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Points a second of the writers of programs, on one thread: 200 000 points in 1000 runs, with the joints of
// an arm, split into files as controllers take them.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/program/rapid/rapid_texts.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace {

using namespace lamina;

constexpr std::size_t kRuns = 1000;
constexpr std::size_t kSides = 198;  // a ring, its return, and a travel to the next one

/// Rings of 60 mm radius above each other.
Toolpath rings() {
  Toolpath toolpath;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const double z = 0.2 * static_cast<double>(run + 1);
    Path ring;
    ring.role = PathRole::OuterWall;
    ring.feed_mm_s = 20.0;
    ring.bead = Bead{0.6, 0.2};
    ring.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
    for (std::size_t i = 0; i <= kSides; ++i) {
      const double at = 2.0 * M_PI * static_cast<double>(i) / kSides;
      ring.points.emplace_back(60.0 * std::cos(at), 60.0 * std::sin(at), z);
    }
    ToolpathLayer layer{z, 0.2, {}};
    if (run > 0) {
      Path travel;
      travel.role = PathRole::Travel;
      travel.feed_mm_s = 100.0;
      travel.orientation = ring.orientation;
      travel.points = {toolpath.layers.back().paths.back().points.back(), ring.points.front()};
      layer.paths.push_back(std::move(travel));
    }
    layer.paths.push_back(std::move(ring));
    toolpath.layers.push_back(std::move(layer));
  }
  return toolpath;
}

/// The rings, and the joints of an arm along them.
struct LedRings {
  LedRings() : arm(kinematicModelByName("irb_4600")), toolpath(rings()) {
    NoProgress nobody;
    JointPathSettings settings;
    settings.yaw = YawChoice::Held;
    joints = planJointPath(toolpath, Eigen::Isometry3d::Identity(), *arm, settings, nobody);
  }

  std::unique_ptr<KinematicModel> arm;
  Toolpath toolpath;
  JointPath joints;
};

const LedRings& ledRings() {
  static const LedRings led;
  return led;
}

void count(benchmark::State& state, std::size_t files, std::size_t bytes) {
  const auto points = static_cast<double>(ledRings().joints.at.size());
  state.counters["points/s"] =
      benchmark::Counter(points * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["points"] = points;
  state.counters["files"] = static_cast<double>(files);
  state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
}

void inLanguage(benchmark::State& state, RobotLanguage language) {
  const LedRings& led = ledRings();
  const RobotMotion robot{*led.arm, led.joints};
  std::vector<RobotFile> files;
  RobotProgramSettings settings;
  settings.krl.max_mb = 100.0;  // of all files: the controller's memory
  for (auto _ : state)
    files = robotProgram(led.toolpath, Eigen::Isometry3d::Identity(), {language, "rings", settings}, &robot);
  std::size_t bytes = 0;
  for (const RobotFile& file : files) bytes += file.text.size();
  count(state, files.size(), bytes);
}

void krl(benchmark::State& state) { inLanguage(state, RobotLanguage::Krl); }
void urscript(benchmark::State& state) { inLanguage(state, RobotLanguage::UrScript); }
void fanuc(benchmark::State& state) { inLanguage(state, RobotLanguage::Fanuc); }
void inform(benchmark::State& state) { inLanguage(state, RobotLanguage::Inform); }

void rapid(benchmark::State& state) {
  const LedRings& led = ledRings();
  const RobotMotion robot{*led.arm, led.joints};
  RapidSettings settings;
  settings.configuration = RapidConfiguration::Joints;
  settings.max_points = 10000;
  std::size_t files = 0;
  std::size_t bytes = 0;
  for (auto _ : state) {
    const RapidTexts texts(RapidProgram(led.toolpath, Eigen::Isometry3d::Identity(), settings, &robot));
    files = texts.modules().size();
    bytes = 0;
    for (const RapidText& module : texts.modules()) bytes += module.text.size();
  }
  count(state, files, bytes);
}

BENCHMARK(rapid)->Unit(benchmark::kMillisecond);
BENCHMARK(krl)->Unit(benchmark::kMillisecond);
BENCHMARK(urscript)->Unit(benchmark::kMillisecond);
BENCHMARK(fanuc)->Unit(benchmark::kMillisecond);
BENCHMARK(inform)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
