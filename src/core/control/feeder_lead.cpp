// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/feeder_lead.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kUndivided = 1e9;         // mm: longer than any path
constexpr double kOwnLength = 1.0 - 1e-6;  // of a path: what lengths that were written and read differ by
constexpr double kMostCells = 2e6;         // of a layer: 2 km of bead at 1 mm, in about 250 MB

const PathCorrection* correctionOf(const CorrectionMap& map, std::size_t path) {
  const auto found = std::find_if(map.paths.begin(), map.paths.end(),
                                  [path](const PathCorrection& each) { return each.path == path; });
  return found == map.paths.end() ? nullptr : &*found;
}

double lengthOf(const LayerCells& undivided, std::size_t path) {
  for (const CellRun& run : undivided.runs)
    if (run.path == path) return run.length_mm;
  return 0.0;
}

/// The least spacing of stations. Where a path of one station has its own length, however short, that asks
/// for no denser ones elsewhere.
double densestStation(const CorrectionMap& map, const LayerCells& undivided) {
  double least = kUndivided;
  for (const PathCorrection& path : map.paths)
    if (path.stations.size() > 1 || path.spacing_mm < kOwnLength * lengthOf(undivided, path.path))
      least = std::min(least, path.spacing_mm);
  return least;
}

/// Two stations on one path may be as dense as a map can be, and the whole layer is divided so.
void requireFewCells(const LayerCells& undivided, double cell_mm) {
  double length_mm = 0.0;
  for (const CellRun& run : undivided.runs) length_mm += run.length_mm;
  if (length_mm / cell_mm <= kMostCells) return;
  throw InvalidInput("correction of layer " + std::to_string(undivided.layer) + ": its " +
                     numberText(length_mm) + " mm of beads, divided by " + numberText(cell_mm) +
                     " mm between stations, are " + numberText(std::round(length_mm / cell_mm)) +
                     " cells; expected at most " + numberText(kMostCells));
}

/// The same once more, as the layer above is taken to begin as this one does.
void repeat(FeederCommands& commands, double layer_s) {
  const std::size_t count = commands.time_s.size();
  for (std::size_t i = 0; i < count; ++i) {
    commands.time_s.push_back(commands.time_s[i] + layer_s);
    commands.amount.push_back(commands.amount[i]);
  }
}

/// What the feeder is commanded for the beginning of the layer above.
void addBeginning(FeederCommands& commands, const ExpectedBeginning& ahead, double layer_s,
                  const FeederDelay& feeder) {
  for (std::size_t i = 0; i < ahead.amount.size(); ++i) {
    const double next = ahead.amount[std::min(i + 1, ahead.amount.size() - 1)];
    const double time_s = layer_s + (static_cast<double>(i) + 0.5) * ahead.interval_s;
    commands.time_s.push_back(time_s - feeder.dead_time_s);
    commands.amount.push_back(ahead.amount[i] + feeder.lag_s * (next - ahead.amount[i]) / ahead.interval_s);
  }
}

/// Linear between the times; as the first and the last value before and after.
double valueAt(const FeederCommands& commands, double time_s) {
  const auto after = std::upper_bound(commands.time_s.begin(), commands.time_s.end(), time_s);
  const auto k = static_cast<std::size_t>(after - commands.time_s.begin());
  if (k == 0) return commands.amount.front();
  if (k == commands.time_s.size()) return commands.amount.back();
  const double part = (time_s - commands.time_s[k - 1]) / (commands.time_s[k] - commands.time_s[k - 1]);
  return commands.amount[k - 1] + part * (commands.amount[k] - commands.amount[k - 1]);
}

bool isPrompt(const FeederDelay& feeder) { return feeder.dead_time_s == 0.0 && feeder.lag_s == 0.0; }

}  // namespace

FeederDelay feederOf(const LoopSettings& settings) { return {settings.dead_time_s, settings.lag_s}; }

std::vector<double> timesOf(const LayerCells& cells) {
  std::vector<double> times(cells.size());
  double now_s = 0.0;
  for (const CellRun& run : cells.runs) {
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const double cell_s = run.cellLength() / cells.speed_mm_s[i];
      times[i] = now_s + 0.5 * cell_s;
      now_s += cell_s;
    }
  }
  return times;
}

FeederCommands feederCommands(const LayerCells& cells, const std::vector<double>& amount,
                              const FeederDelay& feeder, const LoopSettings& settings) {
  FeederCommands commands{timesOf(cells), amount};
  if (isPrompt(feeder)) return commands;
  for (std::size_t i = 0; i + 1 < amount.size() && feeder.lag_s > 0.0; ++i)
    commands.amount[i] +=
        feeder.lag_s * (amount[i + 1] - amount[i]) / (commands.time_s[i + 1] - commands.time_s[i]);
  commands.amount = followedCommands(cells, commands.amount, settings);
  for (double& time_s : commands.time_s) time_s -= feeder.dead_time_s;
  return commands;
}

std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const ExpectedBeginning& ahead, const FeederDelay& feeder,
                                  const LoopSettings& settings) {
  if (isPrompt(feeder) || amount.empty()) return amount;
  const std::vector<double> times = timesOf(cells);
  const CellRun& last = cells.runs.back();
  const double layer_s = times.back() + 0.5 * last.cellLength() / cells.speed_mm_s.back();
  FeederCommands commands = feederCommands(cells, amount, feeder, settings);
  if (ahead.amount.empty())
    repeat(commands, layer_s);
  else
    addBeginning(commands, ahead, layer_s, feeder);
  std::vector<double> led;
  led.reserve(amount.size());
  for (const double time_s : times) led.push_back(valueAt(commands, time_s));
  // What is commanded for the next run while this one is deposited must not step either.
  return followedCommands(cells, led, settings);
}

ExpectedBeginning expectedBeginning(const LayerCells& cells, const std::vector<double>& amount,
                                    double dead_time_s) {
  if (!(dead_time_s > 0.0) || amount.empty()) return {};
  constexpr double kMost = 256.0;
  const FeederCommands wanted{timesOf(cells), amount};
  const double cell_s = cells.runs.front().cellLength() / cells.speed_mm_s.front();
  const double count = std::clamp(std::ceil(dead_time_s / cell_s), 1.0, kMost);
  ExpectedBeginning ahead;
  ahead.interval_s = dead_time_s / count;
  // One more, since the last of them is half an interval before the end.
  for (int i = 0; i <= static_cast<int>(count); ++i)
    ahead.amount.push_back(valueAt(wanted, (i + 0.5) * ahead.interval_s));
  return ahead;
}

CorrectionMap ledMap(const CorrectionMap& map, const ToolpathLayer& layer, const FeederDelay& feeder,
                     const LoopSettings& settings) {
  validate(map);
  if (isPrompt(feeder) || map.paths.empty()) return map;
  const LayerCells undivided = layerCells(layer, map.layer, kUndivided);
  const double cell_mm = densestStation(map, undivided);
  requireFewCells(undivided, cell_mm);
  const LayerCells cells = layerCells(layer, map.layer, cell_mm);
  CellCorrections corrections;
  for (const CellRun& run : cells.runs) {
    const PathCorrection* const path = correctionOf(map, run.path);
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const PointCorrection here =
          path != nullptr ? correctionAt(*path, cells.along_mm[i]) : PointCorrection{};
      corrections.amount.push_back(here.amount);
      corrections.speed.push_back(here.speed);
      corrections.dz_mm.push_back(here.dz_mm);
    }
  }
  corrections.amount = ledCorrection(cells, corrections.amount, map.ahead, feeder, settings);
  CorrectionMap led = correctionMap(cells, corrections, map.toolpath_id, map.sequence);
  for (const PathCorrection& path : map.paths)
    if (correctionOf(led, path.path) == nullptr) led.paths.push_back(path);
  std::sort(led.paths.begin(), led.paths.end(),
            [](const PathCorrection& a, const PathCorrection& b) { return a.path < b.path; });
  return led;
}

}  // namespace lamina
