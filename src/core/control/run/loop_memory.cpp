// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/loop_memory.hpp"

#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/settings_yaml.hpp"

namespace lamina {
namespace {

constexpr Bounds kAnyNumber{-1e9, 1e9};
constexpr Bounds kAnyCount{0.0, 1e9};
constexpr int kMost = 1000000000;
constexpr std::array<std::pair<LoopAlarm, const char*>, 4> kConditions = {
    {{LoopAlarm::Silent, "standing.silent"},
     {LoopAlarm::NoTransform, "standing.no_transform"},
     {LoopAlarm::Stuck, "standing.stuck"},
     {LoopAlarm::TimeOffset, "standing.time_offset"}}};

/// Whole numbers and lists as a schema binds them.
struct StatedMemory {
  LoopMemory memory;
  int layer = 0;
  int judged_layer = 0;
  int layers_begun = 0;
  int clouds = 0;
  RaisedAlarm alarm{};                                                           ///< the last one
  std::array<RaisedAlarm, kConditions.size()> standing{};                        ///< without a reason: none
  int alarm_number = 0;                                                          ///< 0: there was none
  std::vector<std::vector<double>> cells = std::vector<std::vector<double>>(8);  ///< of estimates, by kind
};

void describeStatus(SettingsSchema& schema, StatedMemory& stated) {
  LoopStatus& status = stated.memory.status;
  schema.choice("status.state", status.state,
                {{"off", LoopState::Off},
                 {"identifying", LoopState::Identifying},
                 {"active", LoopState::Active},
                 {"coasting", LoopState::Coasting},
                 {"open", LoopState::Open},
                 {"blocked", LoopState::Blocked}},
                "What the loop did.");
  schema.choice("status.coasting_for", status.coasting_for,
                {{"nothing", CoastingFor::Nothing},
                 {"sight", CoastingFor::Sight},
                 {"time_offset", CoastingFor::TimeOffset},
                 {"suspect", CoastingFor::Suspect}},
                "What it coasted for.");
  schema.text("status.reason", status.reason, "Why.");
  const std::pair<const char*, int*> counts[] = {{"status.unmeasured_layers", &status.unmeasured_layers},
                                                 {"status.saturated_layers", &status.saturated_layers},
                                                 {"status.growing_layers", &status.growing_layers},
                                                 {"status.deviating_layers", &status.deviating_layers},
                                                 {"status.inconsistent_layers", &status.inconsistent_layers},
                                                 {"status.judged_layer", &stated.judged_layer}};
  for (const auto& [key, count] : counts) schema.integer(key, *count, {0.0, kMost}, "Layers, running.");
  schema.flag("status.has_figures", status.has_figures, "Whether a layer was measured.");
  schema.number("status.mean_error_mm", status.mean_error_mm, kAnyNumber, "Of that layer.");
  schema.number("status.rmse_mm", status.rmse_mm, kAnyNumber, "Of that layer.");
}

void describeReaction(SettingsSchema& schema, const std::string& key, LoopReaction& reaction) {
  schema.choice(key, reaction,
                {{"warn", LoopReaction::Warn},
                 {"leave_out", LoopReaction::LeaveOut},
                 {"coast", LoopReaction::Coast},
                 {"open", LoopReaction::Open},
                 {"replan", LoopReaction::Replan},
                 {"hold", LoopReaction::Hold}},
                "To it.");
}

void describeAlarms(SettingsSchema& schema, StatedMemory& stated) {
  schema.integer("alarm.number", stated.alarm_number, {0.0, 65535.0}, "Of the last alarm; 0 for none.");
  describeReaction(schema, "alarm.reaction", stated.alarm.reaction);
  schema.text("alarm.reason", stated.alarm.reason, "What it said.");
  for (std::size_t i = 0; i < kConditions.size(); ++i) {
    const std::string key = kConditions[i].second;
    describeReaction(schema, key + "_reaction", stated.standing[i].reaction);
    schema.text(key, stated.standing[i].reason, "What it says; empty if it does not stand.");
  }
}

/// The lists of the cells' estimates, in the order of `StatedMemory::cells`.
constexpr const char* kEstimateKeys[] = {"cells.error_mm", "cells.variance_mm2", "cells.commanded_mm",
                                         "cells.base_mm",  "cells.contested_mm", "cells.gain",
                                         "cells.contests", "cells.flags"};

void describeCells(SettingsSchema& schema, StatedMemory& stated) {
  for (std::size_t i = 0; i < stated.cells.size(); ++i)
    schema.list(kEstimateKeys[i], stated.cells[i], i < 5 ? kAnyNumber : Bounds{0.0, 255.0}, "One per cell.");
  StoredHeights& heights = stated.memory.heights;
  const std::pair<const char*, std::vector<double>*> lists[] = {
      {"cells.deficit", &heights.deficit},
      {"cells.unseen_error_mm", &heights.before_clouds.error_mm},
      {"cells.unseen_gain", &heights.before_clouds.gain},
      {"cells.unseen_deficit", &heights.before_deficit}};
  for (const auto& [key, list] : lists) schema.list(key, *list, kAnyNumber, "One per cell.");
}

void describe(SettingsSchema& schema, StatedMemory& stated) {
  LoopMemory& memory = stated.memory;
  schema.text("print.toolpath", memory.identity.program, "Toolpath that is printed.");
  schema.text("print.machine", memory.identity.machine, "Machine that prints it.");
  schema.text("print.material", memory.identity.material, "Material that is deposited.");
  schema.integer("print.layer", stated.layer, {0.0, kMost}, "Layer that was done last.");
  describeStatus(schema, stated);
  describeAlarms(schema, stated);
  schema.number("loop.gain_at_check", memory.gain_at_check, kAnyNumber, "At the last check of stability.");
  schema.number("loop.last_amount", memory.last_amount, kAnyNumber, "Correction where the layer ended.");
  schema.number("loop.mean_shift_mm", memory.mean_shift_mm, kAnyNumber, "Of the nozzle's height.");
  schema.number("loop.spread", memory.heights.spread, kAnyCount, "Of growth, as learnt.");
  schema.integer("loop.layers_begun", stated.layers_begun, {0.0, kMost}, "With cells.");
  schema.integer("loop.clouds", stated.clouds, {0.0, kMost}, "That saw the layer.");
  describeCells(schema, stated);
}

StatedMemory statedFrom(const LoopMemory& memory) {
  StatedMemory stated;
  stated.memory = memory;
  stated.layer = static_cast<int>(memory.layer);
  stated.judged_layer = static_cast<int>(memory.status.layer);
  stated.layers_begun = static_cast<int>(memory.heights.layers_begun);
  stated.clouds = static_cast<int>(memory.heights.clouds);
  if (memory.last_alarm) {
    stated.alarm = *memory.last_alarm;
    stated.alarm_number = static_cast<int>(memory.last_alarm->alarm);
  }
  for (const RaisedAlarm& alarm : memory.standing)
    for (std::size_t i = 0; i < kConditions.size(); ++i)
      if (kConditions[i].first == alarm.alarm) stated.standing[i] = alarm;
  for (const StoredEstimate& cell : memory.heights.estimates) {
    const double values[] = {cell.error_mm,     cell.variance_mm2, cell.commanded_mm,   cell.base_mm,
                             cell.contested_mm, cell.gain,         1.0 * cell.contests, 1.0 * cell.flags};
    for (std::size_t i = 0; i < stated.cells.size(); ++i) stated.cells[i].push_back(values[i]);
  }
  return stated;
}

void requireEqualCounts(const StatedMemory& stated, const std::string& source) {
  const StoredHeights& heights = stated.memory.heights;
  const std::size_t cells = stated.cells[0].size();
  std::set<std::size_t> counts = {cells, heights.deficit.size(), heights.before_clouds.error_mm.size(),
                                  heights.before_clouds.gain.size(), heights.before_deficit.size()};
  for (const auto& list : stated.cells) counts.insert(list.size());
  if (counts.size() > 1)
    throw InvalidConfig("'" + source + "' has lists of " + std::to_string(*counts.begin()) + " and of " +
                        std::to_string(*counts.rbegin()) +
                        " cells; expected one value of each kind per cell");
}

StoredEstimate estimateOf(const StatedMemory& stated, std::size_t cell) {
  const auto value = [&](std::size_t kind) { return stated.cells[kind][cell]; };
  StoredEstimate estimate;
  estimate.error_mm = value(0);
  estimate.variance_mm2 = value(1);
  estimate.commanded_mm = value(2);
  estimate.base_mm = value(3);
  estimate.contested_mm = value(4);
  estimate.gain = value(5);
  estimate.contests = static_cast<std::uint8_t>(std::lround(value(6)));
  estimate.flags = static_cast<std::uint8_t>(std::lround(value(7)));
  return estimate;
}

LoopMemory memoryOf(const StatedMemory& stated) {
  LoopMemory memory = stated.memory;
  memory.layer = static_cast<std::size_t>(stated.layer);
  memory.status.layer = static_cast<std::size_t>(stated.judged_layer);
  memory.heights.layers_begun = static_cast<std::size_t>(stated.layers_begun);
  memory.heights.clouds = static_cast<std::size_t>(stated.clouds);
  if (stated.alarm_number > 0) {
    memory.last_alarm = stated.alarm;
    memory.last_alarm->alarm = static_cast<LoopAlarm>(stated.alarm_number);
  }
  memory.standing.clear();
  for (std::size_t i = 0; i < kConditions.size(); ++i) {
    const RaisedAlarm& alarm = stated.standing[i];
    if (!alarm.reason.empty())
      memory.standing.push_back({kConditions[i].first, alarm.reaction, alarm.reason});
  }
  memory.heights.estimates.clear();
  for (std::size_t i = 0; i < stated.cells[0].size(); ++i)
    memory.heights.estimates.push_back(estimateOf(stated, i));
  return memory;
}

}  // namespace

std::string toYaml(const LoopMemory& memory) {
  StatedMemory stated = statedFrom(memory);
  SettingsSchema schema;
  describe(schema, stated);
  return "# What the loop on layer heights knew after a layer.\n" + settingsToYaml(settingTexts(schema));
}

LoopMemory memoryFromYaml(const std::string& yaml, const std::string& source) {
  StatedMemory stated;
  SettingsSchema schema;
  describe(schema, stated);
  std::set<std::string> missing;
  for (const Setting& setting : schema.settings()) missing.insert(setting.key);
  const std::vector<SettingText> settings = settingsFromYaml(yaml, source);
  for (const SettingText& setting : settings) missing.erase(setting.key);
  // What lacks a key may be any file, of which nothing is quoted.
  if (!missing.empty())
    throw InvalidConfig("'" + source + "' has no '" + *missing.begin() +
                        "'; expected what the loop on layer heights keeps of a print");
  for (const SettingText& setting : settings) schema.set(setting.key, setting.text);
  requireEqualCounts(stated, source);
  return memoryOf(stated);
}

LoopMemory readLoopMemory(const std::string& path) { return memoryFromYaml(readFile(path), path); }

void writeLoopMemory(const std::string& path, const LoopMemory& memory) { writeFile(path, toYaml(memory)); }

}  // namespace lamina
