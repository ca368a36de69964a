// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/machine_sheet.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

std::map<std::string, std::string> linesOf(std::istream& sheet) {
  std::map<std::string, std::string> values;
  for (std::string line; std::getline(sheet, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) values[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return values;
}

std::string valueIn(const std::map<std::string, std::string>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? "not stated" : found->second;
}

}  // namespace

std::vector<std::string> machineDifferences(const QueuedJob& job, const BoundMachine& machine,
                                            const ArtefactStore& artefacts) {
  if (job.machine != machine.name)
    return {"the machine is '" + machine.name + "'; expected '" + job.machine + "'"};
  const auto kept = std::find_if(job.artefacts.begin(), job.artefacts.end(),
                                 [](const Artefact& artefact) { return artefact.kind == kMachineSheet; });
  if (kept == job.artefacts.end() || machine.sheet.empty() || kept->sha256 == sha256Of(machine.sheet))
    return {};
  // A file that is gone states nothing: that it is torn is said by a guard of its own.
  std::ifstream file(artefacts.pathOf(*kept));
  const auto before = linesOf(file);
  std::istringstream present(machine.sheet);
  const auto now = linesOf(present);
  auto names = before;
  names.insert(now.begin(), now.end());
  std::vector<std::string> differences;
  for (const auto& [name, value] : names)
    if (valueIn(now, name) != valueIn(before, name))
      differences.push_back(name + " is " + valueIn(now, name) + "; expected " + valueIn(before, name));
  return differences.empty() ? std::vector<std::string>{"its description differs"} : differences;
}

}  // namespace lamina
