// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incline/incline_form.hpp"

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/incline_job.hpp"
#include "lamina/job/output_files.hpp"

namespace lamina {
namespace {

constexpr char kSuffix[] = ".gcode";
constexpr double kLeastAxis = 1e-9;  // as rotations of programs have it

void describe(SettingsSchema& schema, InclineForm& form) {
  schema.text("source", form.source, "Program to incline");
  schema.text("output", form.output, "Program to write");
  schema.number("angle_deg", form.angle_deg, {kLeastInclination, kGreatestInclination}, "Angle of the turn");
  schema.text("axis", form.axis, "x, y, z or three numbers");
  schema.text("machine", form.machine, "Whose limits hold");
  schema.text("begin_code", form.begin_code, "Put after the comments at the head");
  schema.text("end_code", form.end_code, "Put at the end");
  schema.numbers("table_position_mm", form.table_position_mm, 2, "Of the part's middle");
  schema.numbers("final_position_mm", form.final_position_mm, 3, "Of the nozzle at the end");
  schema.flag("drop_build_aids", form.drops_build_aids, "Leave out skirt, brim, raft and support");
}

void requireAxis(const std::string& axis) {
  if (axis == "x" || axis == "y" || axis == "z") return;
  std::vector<double> numbers;
  SettingsSchema schema;
  schema.numbers("axis", numbers, 3, "");
  schema.set("axis", axis);
  if (numbers.empty() || std::hypot(numbers[0], numbers[1], numbers[2]) < kLeastAxis)
    throw InvalidConfig("axis is '" + axis + "', which has no direction; must be x, y, z or a vector");
}

/// Checks angle, axis and all else that can be checked without the files.
void requireSound(InclineForm form) {
  SettingsSchema schema;
  describe(schema, form);
  schema.validate();
  requireAxis(form.axis);
}

}  // namespace

InclineRequest requestOf(const InclineForm& form) {
  if (form.source.empty()) throw InvalidInput("no program is chosen; choose a .gcode file");
  requireSound(form);
  requireSuffix(form.source, {kSuffix});
  InclineRequest request;
  request.program = form.source;
  request.output = form.output.empty() ? inclinedName(form.source) : form.output;
  requireSuffix(request.output, {kSuffix});
  requireApart({request.output}, {request.program});
  for (const auto& [key, text] : textsOf(form))
    if (key != "source" && key != "output" && key != "machine" && key != "drop_build_aids")
      request.settings.push_back({"incline." + key, text});
  request.settings.push_back({"incline.build_aids", form.drops_build_aids ? "drop" : "keep"});
  if (!form.machine.empty()) request.settings.push_back({"machine.name", form.machine});
  return request;
}

std::string outputFor(const std::string& source) {
  const std::string suffix = kSuffix;
  const bool is_program = source.size() > suffix.size() &&
                          source.compare(source.size() - suffix.size(), suffix.size(), suffix) == 0;
  return is_program ? inclinedName(source) : "";
}

std::vector<SettingText> textsOf(const InclineForm& form) {
  InclineForm copy = form;
  SettingsSchema schema;
  describe(schema, copy);
  return settingTexts(schema);
}

InclineForm formFrom(const std::vector<SettingText>& texts) {
  InclineForm form;
  SettingsSchema schema;
  describe(schema, form);
  for (const auto& [key, text] : texts) schema.set(key, text);
  requireSound(form);
  return form;
}

}  // namespace lamina
