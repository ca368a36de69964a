// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>
#include <utility>

#include "lamina/planning/flow/flow.hpp"

namespace lamina {
namespace {

std::string advanceLine(AdvanceWord word, double advance_s) {
  char value[32];
  std::snprintf(value, sizeof value, "%.6g", advance_s);
  switch (word) {
    case AdvanceWord::Klipper:
      return std::string("SET_PRESSURE_ADVANCE ADVANCE=") + value;
    case AdvanceWord::RepRapFirmware:
      return std::string("M572 D0 S") + value;
    case AdvanceWord::Marlin:
      break;
  }
  return std::string("M900 K") + value;
}

}  // namespace

void addAdvance(Toolpath& toolpath, const FlowSettings& settings) {
  if (settings.advance_s == 0.0) return;
  for (ToolpathLayer& layer : toolpath.layers) {
    if (layer.paths.empty()) continue;
    PathEvent told;
    told.event.emplace<MachineCode>(
        MachineCode{advanceLine(settings.advance_word, settings.advance_s), false});
    std::vector<PathEvent>& events = layer.paths.front().events;
    events.insert(events.begin(), std::move(told));
    return;
  }
}

}  // namespace lamina
