// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/study_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "base/strict_yaml.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "lamina/study/placeholders.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/study/study.hpp"

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

/// A file named in a study: relative to its folder, unless it is absolute or there is no folder.
std::string inFolder(const std::string& folder, const std::string& file) {
  if (folder.empty() || file.empty()) return file;
  return (std::filesystem::path(folder) / file).lexically_normal().string();
}

/// The key `slice`. A part that is no file beside the study keeps its name.
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

/// The key `commands`.
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

/// The key `responses`.
/// @throws InvalidConfig too if a response is of no command, or its pointer cannot lead anywhere
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

const std::vector<std::string> kStudyKeys = {
    "name",  "about",      "method",      "variables", "slice", "commands", "responses", "time_limit_s",
    "table", "objectives", "constraints", "search",    "seed",  "decision", "published"};
constexpr double kLongestCommandS = 1e6;
constexpr int kGreatestSeed = 1000000000;

Variable variableFrom(const std::string& name, const StrictYaml& yaml) {
  Variable variable;
  variable.name = name;
  if (yaml.isList()) {
    const std::vector<double> bounds = yaml.numbers();
    if (bounds.size() != 2) yaml.refuse("expected two bounds, [low, high]");
    variable.low = bounds[0], variable.high = bounds[1];
    return variable;
  }
  std::set<std::string> given;
  for (const auto& [key, value] : yaml.entries({"low", "high", "whole", "levels", "choices"})) {
    given.insert(key);
    if (key == "low") variable.low = value.number();
    if (key == "high") variable.high = value.number();
    if (key == "whole" && value.flag()) variable.kind = VariableKind::Integer;
    if (key == "levels") variable.kind = VariableKind::Levels, variable.levels = value.numbers();
    if (key == "choices") variable.kind = VariableKind::Categorical, variable.choices = value.texts();
  }
  given.erase("whole");
  if (given != std::set<std::string>{"low", "high"} && given != std::set<std::string>{"levels"} &&
      given != std::set<std::string>{"choices"})
    yaml.refuse("expected [low, high], or 'low' and 'high', or 'levels', or 'choices'");
  return variable;
}

DesignSpace variablesFrom(const StrictYaml& yaml) {
  DesignSpace space;
  for (const auto& [name, value] : yaml.entries()) {
    space.push_back(variableFrom(name, value));
    try {
      validate({space.back()});
    } catch (const InvalidConfig& error) {
      value.refuse(error.what());
    }
  }
  if (space.empty()) yaml.refuse("expected at least one variable");
  return space;
}

Sense senseFrom(const StrictYaml& yaml) {
  const std::string word = yaml.text();
  if (word != "minimise" && word != "maximise") yaml.refuse("'" + word + "'; expected minimise or maximise");
  return word == "minimise" ? Sense::Minimise : Sense::Maximise;
}

std::vector<Objective> objectivesFrom(const StrictYaml& yaml) {
  std::vector<Objective> objectives;
  for (const auto& [name, value] : yaml.entries()) {
    Objective objective;
    objective.response = name;
    if (value.isScalar()) {
      objective.sense = senseFrom(value);
    } else {
      for (const auto& [key, field] : value.entries({"sense", "weight"})) {
        if (key == "sense") objective.sense = senseFrom(field);
        if (key == "weight") objective.weight = field.number();
        if (objective.weight < 0.0) field.refuse("'" + field.text() + "'; expected at least 0");
      }
    }
    objectives.push_back(objective);
  }
  if (objectives.empty()) yaml.refuse("expected at least one objective");
  return objectives;
}

Constraint constraintFrom(const std::string& name, const StrictYaml& yaml) {
  Constraint constraint;
  constraint.response = name;
  if (yaml.isList()) {
    const std::vector<double> bounds = yaml.numbers();
    if (bounds.size() != 2) yaml.refuse("expected two bounds, [low, high]");
    constraint.low = bounds[0], constraint.high = bounds[1];
  } else {
    for (const auto& [key, value] : yaml.entries({"low", "high"}))
      (key == "low" ? constraint.low : constraint.high) = value.number();
  }
  if (!(constraint.low <= constraint.high)) yaml.refuse("nothing lies between these bounds");
  return constraint;
}

DecisionSettings decisionFrom(const StrictYaml& yaml) {
  DecisionSettings decision;
  for (const auto& [key, value] : yaml.entries({"method", "weights"})) {
    if (key == "method") decision.method = value.text();
    if (decision.method != "linmap" && decision.method != "topsis")
      value.refuse("'" + decision.method + "'; expected linmap or topsis");
    if (key == "weights") {
      for (const auto& [name, weight] : value.entries()) {
        if (weight.number() < 0.0) weight.refuse("'" + weight.text() + "'; expected at least 0");
        decision.weights.push_back({name, weight.text()});
      }
    }
  }
  return decision;
}

void readPublished(const StrictYaml& yaml, Study& study) {
  for (const auto& [key, value] : yaml.entries({"source", "rows"})) {
    if (key == "source") study.published_source = value.text();
    if (key == "rows")
      for (const auto& [name, row] : value.entries()) study.published.push_back({name, row.settings()});
  }
}

void readCommands(const StrictYaml::Entries& entries, Study& study) {
  const auto find = [&](const std::string& key) {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const auto& entry) { return entry.first == key; });
  };
  const auto commands = find("commands");
  const auto responses = find("responses");
  const auto limit = find("time_limit_s");
  if (commands == entries.end()) {
    if (responses != entries.end()) responses->second.refuse("there are no commands to respond");
    if (limit != entries.end()) limit->second.refuse("there are no commands to limit");
    return;
  }
  if (responses == entries.end()) commands->second.refuse("expected the key 'responses' beside it");
  CommandMeasure measure;
  measure.commands = commandsFrom(commands->second);
  measure.responses = responsesFrom(responses->second, measure.commands);
  if (limit != entries.end()) measure.time_limit_s = limit->second.number();
  if (!(measure.time_limit_s > 0.0 && measure.time_limit_s <= kLongestCommandS))
    limit->second.refuse("expected more than 0 and at most 1e6 s");
  study.commands = measure;
}

/// The seed is that of either method, unless `search` names another; so it stands before that.
void readSeed(const StrictYaml::Entries& entries, Study& study) {
  for (const auto& [key, value] : entries) {
    if (key != "seed") continue;
    const std::string seed = std::to_string(value.whole(0, kGreatestSeed));
    study.search.insert(study.search.begin(), {{"nsga2.seed", seed}, {"surrogate.seed", seed}});
  }
}

SearchMethod methodFrom(const StrictYaml& yaml) {
  const std::string word = yaml.text();
  if (word != "nsga2" && word != "surrogate") yaml.refuse("'" + word + "'; expected nsga2 or surrogate");
  return word == "nsga2" ? SearchMethod::Nsga2 : SearchMethod::Surrogate;
}

/// What concerns one key alone.
void readKey(const std::string& key, const StrictYaml& value, Study& study) {
  if (key == "name") study.name = value.text();
  if (key == "about") study.about = value.text();
  if (key == "method") study.method = methodFrom(value);
  if (key == "variables") study.variables = variablesFrom(value);
  if (key == "slice") study.slice = sliceMeasureFrom(value, study.folder);
  if (key == "table") study.table = inFolder(study.folder, value.text());
  if (key == "objectives") study.goals.objectives = objectivesFrom(value);
  if (key == "constraints")
    for (const auto& [name, bounds] : value.entries())
      study.goals.constraints.push_back(constraintFrom(name, bounds));
  if (key == "search") study.search = value.settings();
  if (key == "decision") study.decision = decisionFrom(value);
  if (key == "published") readPublished(value, study);
}

void requireOneMeasure(const StrictYaml& document, const Study& study) {
  if (study.slice && study.commands) document.refuse("'slice' and 'commands' are both there; expected one");
  const bool is_measured = study.slice || study.commands;
  if (!is_measured && study.table.empty())
    document.refuse("nothing measures; expected one of the keys slice, commands, table");
  if (study.method == SearchMethod::Nsga2 && !is_measured)
    document.refuse(
        "a front cannot be searched in a table; expected 'slice' or 'commands', or method surrogate");
  if (study.method == SearchMethod::Nsga2 && !study.table.empty())
    document.refuse("'table' starts a surrogate; expected method surrogate");
}

void requirePlaceholders(const StrictYaml& document, const Study& study) {
  if (!study.commands) return;
  std::set<std::string> known = {"folder"};
  for (const Variable& variable : study.variables) {
    if (variable.name == "folder")
      document.refuse("variables: folder: the name is that of the scratch folder; expected another");
    known.insert(variable.name);
  }
  std::set<std::string> used;
  for (const StudyCommand& command : study.commands->commands)
    for (const std::string& argument : command.arguments)
      for (const std::string& name : placeholdersIn(argument)) {
        if (known.count(name) == 0)
          document.refuse("commands: " + command.name + ": '{" + name + "}' is no variable; there are " +
                          listed({known.begin(), known.end()}));
        used.insert(name);
      }
  for (const Variable& variable : study.variables)
    if (used.count(variable.name) == 0)
      document.refuse("variables: " + variable.name + ": no command has '{" + variable.name + "}'");
}

/// Names are columns of the tables that a study reads and writes.
void requireColumns(const StrictYaml& document, const Study& study) {
  std::set<std::string> columns = {"error", "iteration"};
  for (const Variable& variable : study.variables)
    if (!columns.insert(variable.name).second)
      document.refuse("variables: " + variable.name + ": the name is that of a column of its own in tables");
  for (const std::string& response : responseNames(study))
    if (!columns.insert(response).second)
      document.refuse("response " + response +
                      ": a variable, another response, or a column of its own in tables has this name");
}

/// Settings of the search are checked once it is known what measures.
void requireSearch(const StrictYaml::Entries& entries, const Study& study) {
  for (const auto& [key, value] : entries) {
    if (key != "search") continue;
    try {
      searchSettingsOf(study);
    } catch (const InvalidConfig& error) {
      value.refuse(error.what());
    }
  }
}

void requireConsistent(const StrictYaml& document, const Study& study) {
  if (study.variables.empty()) document.refuse("expected the key 'variables'");
  if (study.goals.objectives.empty()) document.refuse("expected the key 'objectives'");
  requireOneMeasure(document, study);
  requirePlaceholders(document, study);
  requireColumns(document, study);
  try {
    validate(study.goals, responseNames(study));
  } catch (const InvalidConfig& error) {
    document.refuse(error.what());
  }
}

}  // namespace

Study readStudy(const std::string& yaml, const std::string& source_name, const std::string& folder) {
  try {
    const StrictYaml document(YAML::Load(yaml), source_name, "");
    const StrictYaml::Entries entries = document.entries(kStudyKeys);
    Study study;
    study.folder = folder;
    for (const auto& [key, value] : entries) readKey(key, value, study);
    readCommands(entries, study);
    readSeed(entries, study);
    requireConsistent(document, study);
    requireSearch(entries, study);
    if (study.name.empty()) study.name = std::filesystem::path(source_name).stem().string();
    return study;
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(source_name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

Study readStudyFile(const std::string& path) {
  Study study =
      readStudy(readFile(path, kMostSettingsBytes), path, std::filesystem::path(path).parent_path().string());
  study.file = path;
  return study;
}

}  // namespace lamina
