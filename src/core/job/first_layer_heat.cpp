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

struct HeatChange {
  double from_c;
  double to_c;
};

/// Nothing where the temperature stays, or the program leaves the heater alone.
std::string heatLine(const char* word, const HeatChange& change) {
  if (change.from_c == 0.0 || change.to_c == 0.0 || change.from_c == change.to_c) return "";
  char line[64];
  std::snprintf(line, sizeof line, "%s S%g\n", word, change.to_c);
  return line;
}

std::string heatCode(const HeatChange& nozzle, const HeatChange& bed) {
  return heatLine("M104", nozzle) + heatLine("M140", bed);
}

void precede(ToolpathLayer& layer, const std::string& code) {
  PathEvent change;
  change.event.emplace<MachineCode>().text = code;
  std::vector<PathEvent>& events = layer.paths.front().events;
  events.insert(events.begin(), std::move(change));
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
                            const ProgramSettings& settings, PlateOrder order) {
  const double nozzle_c = first_layer.nozzle_temperature_c;
  const double bed_c = first_layer.bed_temperature_c;
  const std::string of_rest =
      heatCode({nozzle_c, settings.nozzle_temperature_c}, {bed_c, settings.bed_temperature_c});
  const std::string of_first =
      heatCode({settings.nozzle_temperature_c, nozzle_c}, {settings.bed_temperature_c, bed_c});
  if (of_rest.empty()) return;
  const ToolpathLayer* below = nullptr;
  bool is_at_first = true;
  for (ToolpathLayer& layer : toolpath.layers) {
    if (layer.paths.empty()) continue;
    const bool begins_part = below == nullptr || (order == PlateOrder::ByPart && layer.z_mm < below->z_mm);
    if (begins_part != is_at_first) precede(layer, begins_part ? of_first : of_rest);
    is_at_first = begins_part;
    below = &layer;
  }
}

}  // namespace lamina
