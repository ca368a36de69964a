// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/start_code.hpp"

#include <Eigen/LU>

#include "lamina/base/error.hpp"
#include "lamina/base/placeholders.hpp"
#include "program/gcode/fixed_point.hpp"

namespace lamina {
namespace {

/// What placeholders stand for.
struct Placeholders {
  const std::string& key;
  const ProgramSettings& settings;
  char lift_axis;
};

/// Of the axes that the program speaks, the one along which the nozzle rises from the bed most directly.
char liftAxis(const ProgramFrame& frame) {
  const Eigen::Matrix3d bed_from_program = frame.program_from_bed.linear().inverse();
  Eigen::Index axis = 0;
  bed_from_program.colwise().normalized().row(2).maxCoeff(&axis);
  return "XYZ"[axis];
}

double temperatureOf(const std::string& name, const Placeholders& placeholders) {
  if (name == "nozzle_temperature_c") return placeholders.settings.nozzle_temperature_c;
  if (name == "bed_temperature_c") return placeholders.settings.bed_temperature_c;
  throw InvalidConfig(placeholders.key + " holds the placeholder {" + name +
                      "}; must be {nozzle_temperature_c}, {bed_temperature_c} or {lift_axis}");
}

/// @return its text, empty if the line is to be left out
std::string valueOf(const std::string& name, const Placeholders& placeholders) {
  if (name == "lift_axis") return {placeholders.lift_axis};
  const double value = temperatureOf(name, placeholders);
  if (value == 0.0) return "";
  char digits[32];
  return {digits, writeFixed<3>(digits, toUnits(value, 1e3))};
}

}  // namespace

std::string expandCode(const std::string& key, const std::string& code, const ProgramSettings& settings,
                       const ProgramFrame& frame) {
  const Placeholders placeholders{key, settings, liftAxis(frame)};
  return expandPlaceholders(key, code,
                            [&placeholders](const std::string& name) { return valueOf(name, placeholders); });
}

}  // namespace lamina
