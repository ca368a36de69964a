// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/measure_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "lamina/base/text.hpp"

namespace lamina {
namespace {

std::vector<Baseline> baselinesFrom(const StrictYaml& yaml) {
  std::vector<Baseline> baselines;
  for (const auto& [name, settings] : yaml.entries()) baselines.push_back({name, settings.settings()});
  return baselines;
}

void requirePointer(const StrictYaml& yaml, const std::string& pointer) {
  try {
    const nlohmann::json::json_pointer parsed(pointer);
    if (parsed.empty()) yaml.refuse("the pointer is empty; expected one as /porosity_percent");
  } catch (const nlohmann::json::exception&) {
    yaml.refuse("'" + pointer + "' is no JSON pointer; expected one as /porosity_percent");
  }
}

CommandResponse responseFrom(const std::string& name, const StrictYaml& yaml) {
  CommandResponse response;
  response.name = name;
  for (const auto& [key, value] : yaml.entries({"command", "pointer"}))
    (key == "command" ? response.command : response.pointer) = value.text();
  if (response.command.empty()) yaml.refuse("expected the key 'command'");
  requirePointer(yaml, response.pointer);
  return response;
}

}  // namespace

std::string inFolder(const std::string& folder, const std::string& file) {
  if (folder.empty() || file.empty()) return file;
  return (std::filesystem::path(folder) / file).lexically_normal().string();
}

SliceMeasure sliceMeasureFrom(const StrictYaml& yaml, const std::string& folder) {
  SliceMeasure measure;
  for (const auto& [key, value] :
       yaml.entries({"part", "parameters", "config", "settings", "metrics", "front_metrics", "baselines"})) {
    if (key == "part") measure.part = value.text();
    if (key == "parameters") measure.parameters = value.settings();
    if (key == "config") measure.config = inFolder(folder, value.text());
    if (key == "settings") measure.settings = value.settings();
    if (key == "metrics") measure.metrics = value.texts();
    if (key == "front_metrics") measure.front_metrics = value.texts();
    if (key == "baselines") measure.baselines = baselinesFrom(value);
  }
  if (measure.part.empty()) yaml.refuse("expected the key 'part'");
  std::error_code unreachable;
  const std::string beside = inFolder(folder, measure.part);
  if (std::filesystem::exists(beside, unreachable)) measure.part = beside;
  return measure;
}

std::vector<StudyCommand> commandsFrom(const StrictYaml& yaml) {
  std::vector<StudyCommand> commands;
  for (const auto& [name, arguments] : yaml.entries()) {
    commands.push_back({name, arguments.texts()});
    if (commands.back().arguments.empty() || commands.back().arguments.front().empty())
      arguments.refuse("expected a program and its arguments");
  }
  if (commands.empty()) yaml.refuse("expected at least one command");
  return commands;
}

std::vector<CommandResponse> responsesFrom(const StrictYaml& yaml,
                                           const std::vector<StudyCommand>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const StudyCommand& command : commands) names.push_back(command.name);
  std::vector<CommandResponse> responses;
  for (const auto& [name, value] : yaml.entries()) {
    responses.push_back(responseFrom(name, value));
    const std::string& command = responses.back().command;
    if (std::find(names.begin(), names.end(), command) == names.end())
      value.refuse("there is no command '" + command + "'; there are " + listed(names));
  }
  if (responses.empty()) yaml.refuse("expected at least one response");
  return responses;
}

}  // namespace lamina
