// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/nozzle_csv.hpp"

#include <algorithm>
#include <iterator>

#include "base/decimals.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr int kDecimals = 6;  // us, nm, nm/s
constexpr int kTurnDecimals = 9;
constexpr std::size_t kRowsAtOnce = 1000;

void appendField(std::string& text, double value, int decimals) {
  appendDecimals(text, value, decimals);
  text += ',';
}

std::string headerOf(const NozzleTable& table) {
  std::string text = "t,x,y,z,qw,qx,qy,qz,v,flow_mm3_s,laser,wire,powder,gas";
  for (const ProcessLevel level : table.levels) text += std::string(",") + nameOf(level);
  return text + "\n";
}

void appendProcess(std::string& text, const ProcessSignals& process, const NozzleTable& table) {
  appendField(text, process.flow_mm3_s, kDecimals);
  for (const bool is_on : {process.is_laser_on, process.is_wire_fed, process.is_powder_on, process.is_gas_on})
    text += is_on ? "1," : "0,";
  for (const ProcessLevel level : table.levels)
    if (process.levels.has(level))
      appendField(text, process.levels[level], kDecimals);
    else
      text += ',';
}

void appendRow(std::string& text, const NozzleState& state, const NozzleTable& table) {
  appendField(text, state.time_s, kDecimals);
  for (const double value : {state.tip.x(), state.tip.y(), state.tip.z()})
    appendField(text, value, kDecimals);
  const Eigen::Quaterniond& q = state.orientation;
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) appendField(text, value, kTurnDecimals);
  appendField(text, state.velocity.norm(), kDecimals);
  appendProcess(text, state.process, table);
  text.back() = '\n';
}

}  // namespace

std::vector<ProcessLevel> levelsIn(const Toolpath& toolpath) {
  ProcessLevels stated;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      const ProcessLevels levels = levelsTo(path, 0);
      for (const ProcessLevel level : kAllProcessLevels)
        if (levels.has(level)) stated[level] = levels[level];
    }
  std::vector<ProcessLevel> found;
  std::copy_if(kAllProcessLevels.begin(), kAllProcessLevels.end(), std::back_inserter(found),
               [&stated](ProcessLevel level) { return stated.has(level); });
  return found;
}

void requireNozzleRate(double rate_hz) {
  if (rate_hz >= kNozzleRates.low && rate_hz <= kNozzleRates.high) return;
  throw InvalidConfig("the rate of a Cartesian trajectory is " + numberText(rate_hz) +
                      " Hz; expected 50 to 500 Hz");
}

void writeNozzleCsv(const std::string& file, const JointTrajectory& trajectory, const KinematicModel& model,
                    const NozzleTable& table) {
  requireNozzleRate(table.rate_hz);
  AtomicFile written(file);
  written.write(headerOf(table));
  const std::vector<double> times = evenTimes(0.0, trajectory.duration(), 1.0 / table.rate_hz);
  std::string text;
  Eigen::Quaterniond last = nozzleDown();
  for (std::size_t i = 0; i < times.size(); ++i) {
    NozzleState state = nozzleState(trajectory.at(times[i]), model);
    last = state.orientation = alignedWith(state.orientation, last);
    appendRow(text, state, table);
    if ((i + 1) % kRowsAtOnce != 0) continue;
    written.write(text);
    text.clear();
  }
  written.write(text);
  written.commit();
}

}  // namespace lamina
