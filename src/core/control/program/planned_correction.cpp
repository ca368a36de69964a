// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/planned_correction.hpp"

#include <sstream>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/control/feeder_lead.hpp"

namespace lamina {

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
  const std::vector<CorrectionMap> maps = ledMaps(correction);
  std::istringstream text(program);
  requireLaysToolpath(name, text, correction.planned.toolpath);
  return correctedProgram(program, correction.planned.toolpath, maps, {});
}

}  // namespace lamina
