// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/start_code.hpp"

#include <sstream>

#include "lamina/base/error.hpp"
#include "program/fixed_point.hpp"

namespace lamina {
namespace {

double placeholderValue(const std::string& key, const std::string& name, const ProgramSettings& settings) {
  if (name == "nozzle_temperature_c") return settings.nozzle_temperature_c;
  if (name == "bed_temperature_c") return settings.bed_temperature_c;
  throw InvalidConfig(key + " holds the placeholder {" + name +
                      "}; must be {nozzle_temperature_c} or {bed_temperature_c}");
}

/// @return the line, empty if it is to be left out
std::string expandLine(const std::string& key, std::string line, const ProgramSettings& settings) {
  for (std::size_t open = line.find('{'); open != std::string::npos; open = line.find('{', open)) {
    const std::size_t close = line.find('}', open);
    if (close == std::string::npos)
      throw InvalidConfig(key + " has '{' without '}' in the line '" + line + "'");
    const double value = placeholderValue(key, line.substr(open + 1, close - open - 1), settings);
    if (value == 0.0) return "";
    char digits[32];
    line.replace(open, close - open + 1, digits,
                 static_cast<std::size_t>(writeFixed<3>(digits, toUnits(value, 1e3)) - digits));
  }
  return line + "\n";
}

}  // namespace

std::string expandCode(const std::string& key, const std::string& code, const ProgramSettings& settings) {
  std::istringstream lines(code);
  std::string expanded;
  for (std::string line; std::getline(lines, line);) expanded += expandLine(key, line, settings);
  return expanded;
}

}  // namespace lamina
