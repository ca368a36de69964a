// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/study/study_measurement.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/base/version.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/modifiers/modifier.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/metrics/toolpath_metrics.hpp"
#include "lamina/study/command_measurement.hpp"

namespace lamina {
namespace {

/// Sets without asking whether values fit each other: only single keys are to be checked.
void requireSettable(const SliceMeasure& slice, const std::vector<SettingText>& overrides) {
  JobSettings settings;
  SettingsSchema schema;
  describe(schema, settings);
  applySettings(schema, slice.config, slice.settings);
  for (const SettingText& setting : overrides) schema.set(setting.key, setting.text);
}

std::vector<std::string> extremesOf(const Variable& variable) {
  if (variable.kind == VariableKind::Categorical) return variable.choices;
  return {textOf(variable, lowOf(variable)), textOf(variable, highOf(variable))};
}

void requireKeys(const Study& study) {
  for (const Variable& variable : study.variables) {
    for (const std::string& text : extremesOf(variable)) {
      try {
        requireSettable(*study.slice, {{variable.name, text}});
      } catch (const InvalidConfig& error) {
        throw InvalidConfig("variable " + variable.name + ": " + error.what());
      }
    }
  }
  for (const Baseline& baseline : study.slice->baselines) {
    try {
      requireSettable(*study.slice, baseline.settings);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig("baseline " + baseline.name + ": " + error.what());
    }
  }
}

/// A named part with parameters becomes a file for as long as it is read.
SliceMeasurement sliceMeasurementOf(const SliceMeasure& slice) {
  const JobSettings settings = loadJobSettings(slice.config, slice.settings);
  if (slice.parameters.empty()) return SliceMeasurement({slice.part, "", settings});
  const ScratchFolder folder;
  const std::string file =
      folder.path() + "/" + std::filesystem::path(slice.part).filename().string() + ".stl";
  writeStl(file, makePart(slice.part, slice.parameters));
  return SliceMeasurement({file, "", settings});
}

std::string hashed(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// Pieces of text such that none runs into the next.
void add(std::string& all, const std::string& piece) { all += std::to_string(piece.size()) + ":" + piece; }

/// What a name stands for: the bytes of the file, or itself.
std::string bytesOf(const std::string& file) {
  std::error_code unreachable;
  return std::filesystem::is_regular_file(file, unreachable) ? readFile(file) : file;
}

/// Files that the setting names anywhere in the study: for all points, as a variable, and in baselines.
std::vector<std::string> filesNamedBy(const std::string& key, const std::string& of_all, const Study& study) {
  std::vector<std::string> texts = {of_all};
  for (const Variable& variable : study.variables)
    if (variable.name == key) texts.insert(texts.end(), variable.choices.begin(), variable.choices.end());
  for (const Baseline& baseline : study.slice->baselines)
    for (const SettingText& setting : baseline.settings)
      if (setting.key == key) texts.push_back(setting.text);
  texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
  return texts;
}

/// A list of modifiers and the meshes that it names. One that cannot be read stops the points that use it,
/// not the study.
void addModifiers(std::string& all, const std::string& file) {
  add(all, bytesOf(file));
  try {
    for (const Modifier& modifier : readModifiersFile(file)) add(all, bytesOf(modifier.mesh));
  } catch (const Error&) {
    return;
  }
}

/// The description of a machine, and of a cell what it is put together to.
void addMachine(std::string& all, const std::string& file) {
  add(all, bytesOf(file));
  try {
    if (isCellFile(file)) add(all, readMachineDescription(file));
  } catch (const Error&) {
    return;
  }
}

/// What is read for settings that name files; nothing for those that name none.
void addNamedFiles(std::string& all, const JobSettings& settings, const Study& study) {
  for (const std::string& file : filesNamedBy("part.modifiers", settings.modifiers, study))
    addModifiers(all, file);
  for (const std::string& file : filesNamedBy("slicing.heights_file", settings.slicing.heights_file, study))
    add(all, bytesOf(file));
  for (const std::string& file :
       filesNamedBy("volumetric.target_file", settings.volumetric.target_file, study))
    add(all, bytesOf(file));
  for (const std::string& file : filesNamedBy("machine.urdf", settings.machine.urdf, study))
    addMachine(all, file);
}

std::string settingsYaml(const SliceMeasure& slice, const std::vector<SettingText>& overrides) {
  std::vector<SettingText> all = slice.settings;
  all.insert(all.end(), overrides.begin(), overrides.end());
  JobSettings settings = loadJobSettings(slice.config, all);
  SettingsSchema schema;
  describe(schema, settings);
  return settingsToYaml(schema);
}

}  // namespace

StudyMeasurement::StudyMeasurement(const Study& study)
    : study_(study), response_names_(lamina::responseNames(study)), front_response_names_(response_names_) {
  if (study.commands) commands_ = commandMeasurement(study);
  if (!study.slice) return;
  const auto& front = study.slice->front_metrics;
  front_response_names_ = front.empty() ? metricNames() : front;
  for (const std::string& name : response_names_) responseIndex(metricNames(), name);
  for (const std::string& name : front_response_names_) responseIndex(metricNames(), name);
  for (const std::string& name : response_names_) responseIndex(front_response_names_, name);
  requireKeys(study);
  slices_ = std::make_shared<const SliceMeasurement>(sliceMeasurementOf(*study.slice));
}

std::vector<SettingText> StudyMeasurement::overridesAt(const DesignPoint& point) const {
  std::vector<SettingText> overrides;
  for (std::size_t i = 0; i < study_.variables.size(); ++i)
    overrides.push_back({study_.variables[i].name, textOf(study_.variables[i], point.at(i))});
  return overrides;
}

std::vector<double> StudyMeasurement::at(const DesignPoint& point, Progress& progress) const {
  if (commands_) return commands_(point, progress);
  if (!slices_) throw InvalidInput("nothing measures but the table; somebody has to");
  return slices_->measure(overridesAt(point), response_names_, progress);
}

std::vector<double> StudyMeasurement::inFull(const DesignPoint& point, Progress& progress) const {
  return slices_ ? slices_->measure(overridesAt(point), front_response_names_, progress)
                 : at(point, progress);
}

std::vector<double> StudyMeasurement::ofBaseline(const Baseline& baseline, Progress& progress) const {
  if (!slices_) throw InvalidInput("baselines are of studies that slice");
  return slices_->measure(baseline.settings, front_response_names_, progress);
}

std::string StudyMeasurement::configurationAt(const DesignPoint& point) const {
  if (study_.slice) return settingsYaml(*study_.slice, overridesAt(point));
  return settingsToYaml(overridesAt(point));
}

std::string StudyMeasurement::fingerprint() const {
  std::string all;
  add(all, laminaVersion());
  if (study_.slice) {
    add(all, settingsYaml(*study_.slice, {}));
    add(all, bytesOf(study_.slice->part));
    const JobSettings settings = loadJobSettings(study_.slice->config, study_.slice->settings);
    add(all, bytesOf(settings.conformal.base));
    addNamedFiles(all, settings, study_);
    for (const SettingText& parameter : study_.slice->parameters)
      add(all, parameter.key), add(all, parameter.text);
  }
  if (study_.commands) {
    for (const StudyCommand& command : study_.commands->commands) {
      add(all, command.name), add(all, std::to_string(command.arguments.size()));
      for (const std::string& argument : command.arguments) add(all, argument);
    }
    for (const CommandResponse& response : study_.commands->responses)
      add(all, response.command), add(all, response.pointer);
  }
  return hashed(all);
}

}  // namespace lamina
