// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/first_layer_heat.hpp"

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

double startingAt(const std::string& name, double first_c, double program_c, const std::string& start_code) {
  if (first_c == 0.0) return program_c;
  if (start_code.find("{" + name + "}") == std::string::npos)
    throw InvalidConfig("first_layer." + name + " is " + numberText(first_c) +
                        " degrees C, but program.start_code does not hold {" + name + "}, which it replaces");
  return first_c;
}

/// Nothing where the temperature stays, or the program leaves the heater alone.
std::string heatLine(const char* word, double first_c, double program_c) {
  if (first_c == 0.0 || program_c == 0.0 || first_c == program_c) return "";
  char line[64];
  std::snprintf(line, sizeof line, "%s S%g\n", word, program_c);
  return line;
}

}  // namespace

ProgramSettings startedFor(const FirstLayerSettings& first_layer, ProgramSettings settings) {
  settings.nozzle_temperature_c = startingAt("nozzle_temperature_c", first_layer.nozzle_temperature_c,
                                             settings.nozzle_temperature_c, settings.start_code);
  settings.bed_temperature_c = startingAt("bed_temperature_c", first_layer.bed_temperature_c,
                                          settings.bed_temperature_c, settings.start_code);
  return settings;
}

void addHeatAfterFirstLayer(Toolpath& toolpath, const FirstLayerSettings& first_layer,
                            const ProgramSettings& settings) {
  MachineCode code;
  code.text = heatLine("M104", first_layer.nozzle_temperature_c, settings.nozzle_temperature_c) +
              heatLine("M140", first_layer.bed_temperature_c, settings.bed_temperature_c);
  if (code.text.empty()) return;
  bool is_first = true;
  for (ToolpathLayer& layer : toolpath.layers) {
    if (layer.paths.empty() || std::exchange(is_first, false)) continue;
    PathEvent change;
    change.event.emplace<MachineCode>(std::move(code));
    std::vector<PathEvent>& events = layer.paths.front().events;
    events.insert(events.begin(), std::move(change));
    return;
  }
}

}  // namespace lamina
