// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/planned_correction.hpp"

#include <sstream>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/control/feeder_lead.hpp"

namespace lamina {
namespace {

struct MapsOfProgram {
  std::vector<CorrectionMap> of_layers;
  std::vector<LaterMap> of_lines;
};

void requireOneMap(const std::vector<CorrectionMap>& of_layers, const FiledMap& next) {
  if (of_layers.empty() || of_layers.back().layer != next.map.layer) return;
  throw InvalidInput(
      next.file + ": the map of layer " + std::to_string(next.map.layer) + " holds from line " +
      std::to_string(next.from_line) +
      " on of the program that it was recorded of; expected that program, or one map per layer");
}

MapsOfProgram mapsOfProgram(const PlannedCorrection& correction) {
  MapsOfProgram maps;
  std::vector<CorrectionMap> led = ledMaps(correction);
  for (std::size_t i = 0; i < led.size(); ++i) {
    const FiledMap& filed = correction.maps[i];
    if (correction.is_recorded_program && filed.from_line > 0) {
      maps.of_lines.push_back({filed.from_line, std::move(led[i])});
      continue;
    }
    requireOneMap(maps.of_layers, filed);
    maps.of_layers.push_back(std::move(led[i]));
  }
  return maps;
}

}  // namespace

void requireOfProgram(const PlannedCorrection& correction) {
  for (const FiledMap& each : correction.maps) {
    const std::string defect = defectOf(each.map, correction.planned);
    if (!defect.empty()) throw InvalidInput(each.file + ": the map " + defect);
  }
}

std::vector<CorrectionMap> ledMaps(const PlannedCorrection& correction) {
  const Toolpath& toolpath = correction.planned.toolpath;
  const std::string programmed_id = toolpathId(toolpath);
  std::vector<CorrectionMap> maps;
  maps.reserve(correction.maps.size());
  for (const FiledMap& each : correction.maps) {
    CorrectionMap led =
        ledMap(each.map, toolpath.layers[each.map.layer], feederOf(correction.feeding), correction.feeding);
    led.toolpath_id = programmed_id;
    maps.push_back(std::move(led));
  }
  return maps;
}

std::string feedingText(const LoopSettings& feeding) {
  LoopSettings shown = feeding;
  SettingsSchema schema;
  describeFeeding(schema, shown);
  std::string text;
  for (const Setting& setting : schema.settings())
    text += (text.empty() ? "" : " ") + setting.key + "=" + setting.get();
  return text;
}

void requireLaysToolpath(const std::string& name, std::istream& program, const Toolpath& toolpath) {
  // Any amount would do, as long as each depositing line changes by it.
  CorrectionMap everything{toolpathId(toolpath), 0, 0, {}};
  std::vector<CorrectionMap> maps;
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k) {
    everything.layer = k;
    everything.paths.clear();
    for (std::size_t p = 0; p < toolpath.layers[k].paths.size(); ++p)
      everything.paths.push_back({p, 1e9, {{1.0, 0.0, 0.0}}});
    maps.push_back(everything);
  }
  ProgramCorrector trial(toolpath, maps, {});
  std::string line;
  std::string out;
  for (std::size_t number = 1; std::getline(program, line); ++number) {
    out.clear();
    trial.read(line, number, out);
  }
  if (trial.report().corrected_lines > 0) return;
  throw InvalidProgram(name + " deposits nothing on the toolpath " +
                       (toolpath.part_name.empty() ? "given" : "of '" + toolpath.part_name + "'") +
                       "; expected its program, to correct it");
}

CorrectedProgram correctedByMaps(const std::string& name, const std::string& program,
                                 const PlannedCorrection& correction) {
  requireOfProgram(correction);
  const MapsOfProgram maps = mapsOfProgram(correction);
  std::istringstream text(program);
  requireLaysToolpath(name, text, correction.planned.toolpath);
  return correctedProgram(program, correction.planned.toolpath, maps.of_layers, {}, maps.of_lines);
}

}  // namespace lamina
