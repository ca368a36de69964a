// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/stated_equipment.hpp"

#include "base/decimals.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::string shownAxes(const StatedEquipment& equipment) {
  if (equipment.external.empty()) return "none";
  std::string text = std::to_string(equipment.external.size()) + " (";
  for (const double value : equipment.external) {
    if (text.back() != '(') text += ", ";
    appendShortest(text, value);
  }
  return text + (equipment.moves_external ? " at the first move, others later)" : " at all moves)");
}

std::string shownCarrier(const std::string& carrier) {
  return carrier.empty() ? "stands still" : "is carried by " + carrier;
}

std::string shownProcess(const std::set<std::string>& process) {
  if (process.empty()) return "nothing";
  std::string text;
  for (const std::string& each : process) text += (text.empty() ? "'" : ", '") + each + "'";
  return text;
}

}  // namespace

void requireSameEquipment(const StatedEquipment& read, const StatedEquipment& written,
                          const std::string& program, const std::string& keys) {
  const std::string as_written = ", as it would be written anew by " + keys;
  if (read.external != written.external || read.moves_external != written.moves_external)
    throw InvalidInput("the external axes of '" + program + "' are " + shownAxes(read) + "; expected " +
                       shownAxes(written) + as_written);
  if (read.bed_carrier != written.bed_carrier)
    throw InvalidInput("the bed of '" + program + "' " + shownCarrier(read.bed_carrier) +
                       "; expected one that " + shownCarrier(written.bed_carrier) + as_written);
  if (read.process != written.process)
    throw InvalidInput("the process of '" + program + "' is switched by " + shownProcess(read.process) +
                       "; expected " + shownProcess(written.process) + as_written);
}

}  // namespace lamina
