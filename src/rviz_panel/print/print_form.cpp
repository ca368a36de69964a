// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "print/print_form.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/profiles/profile_library.hpp"

namespace lamina {
namespace {

constexpr char kProgramSuffix[] = ".gcode";

void describe(SettingsSchema& schema, PrintForm& form) {
  schema.text("part", form.part, "Part to print");
  schema.text("program", form.program, "Program to write");
  schema.text("machine", form.machine, "That prints");
  schema.text("material", form.material, "That is deposited");
  schema.text("process", form.process, "How it is deposited");
  schema.text("settings", form.settings, "Lines of key = value");
}

SettingText settingOf(const std::string& line) {
  const std::size_t sign = line.find('=');
  SettingText setting;
  if (sign != std::string::npos) {
    setting.key = boost::algorithm::trim_copy(line.substr(0, sign));
    setting.text = boost::algorithm::trim_copy(line.substr(sign + 1));
  }
  if (setting.key.empty())
    throw InvalidInput("the setting '" + line +
                       "' is none; write key = value, as slicing.layer_height_mm = 0.3");
  return setting;
}

std::vector<SettingText> settingsIn(const std::string& text) {
  std::vector<SettingText> settings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = boost::algorithm::trim_copy(line.substr(0, line.find('#')));
    if (!line.empty()) settings.push_back(settingOf(line));
  }
  return settings;
}

/// The last word on each setting that the form says anything of.
std::vector<SettingText> setBy(const PrintForm& form) {
  SettingsSources sources;
  sources.machine = form.machine;
  sources.material = form.material;
  sources.process = form.process;
  sources.overrides = settingsIn(form.settings);
  const LayeredSettings layered = loadLayered(sources, ProfileLibrary(profileFolders()));
  validate(layered);
  std::vector<SettingText> settings;
  for (const auto& [key, origins] : layered.origins) settings.push_back({key, origins.back().text});
  return settings;
}

}  // namespace

bool isProgram(const std::string& part) { return boost::algorithm::iends_with(part, kProgramSuffix); }

std::string programOf(const PrintForm& form) {
  if (isProgram(form.part)) return form.part;
  if (!form.program.empty()) return form.program;
  const std::filesystem::path part(form.part);
  return part.has_extension() ? std::filesystem::path(part).replace_extension(kProgramSuffix).string() : "";
}

SliceRequest requestOf(const PrintForm& form) {
  if (form.part.empty()) throw InvalidInput("no part is chosen; choose a mesh file, or drop one here");
  if (isProgram(form.part)) throw InvalidInput("'" + form.part + "' is a program already; press Print");
  SliceRequest request{form.part, programOf(form), {}};
  if (request.program.empty())
    throw InvalidInput("the part '" + form.part + "' is no file; say which program to write");
  requireSuffix(request.program, {kProgramSuffix});
  requireApart({request.program}, {request.part});
  request.settings = setBy(form);
  return request;
}

std::vector<SettingText> textsOf(const PrintForm& form) {
  PrintForm copy = form;
  SettingsSchema schema;
  describe(schema, copy);
  return settingTexts(schema);
}

PrintForm printFormFrom(const std::vector<SettingText>& texts) {
  PrintForm form;
  SettingsSchema schema;
  describe(schema, form);
  for (const auto& [key, text] : texts) schema.set(key, text);
  return form;
}

std::string durationText(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  const long hours = whole / 3600;
  const long minutes = whole / 60 % 60;
  if (hours > 0) return std::to_string(hours) + " h " + std::to_string(minutes) + " min";
  if (minutes > 0) return std::to_string(minutes) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole) + " s";
}

}  // namespace lamina
