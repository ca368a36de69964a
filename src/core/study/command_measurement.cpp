// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/command_measurement.hpp"

#include <nlohmann/json.hpp>

#include "lamina/base/child_process.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/scratch_folder.hpp"
#include "lamina/base/text.hpp"
#include "lamina/study/placeholders.hpp"

namespace lamina {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostOfErrors = 500;

/// What a person needs of it: its end, in whole characters of UTF-8.
std::string tail(const std::string& text) {
  std::string shown(trimmed(text));
  if (shown.size() <= kMostOfErrors) return shown;
  const auto isWithinCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  std::size_t begin = shown.size() - kMostOfErrors;
  while (begin < shown.size() && isWithinCharacter(shown[begin])) ++begin;
  return "..." + shown.substr(begin);
}

std::map<std::string, std::string> valuesAt(const DesignSpace& space, const DesignPoint& point,
                                            const std::string& folder) {
  std::map<std::string, std::string> values = {{"folder", folder}};
  for (std::size_t i = 0; i < space.size(); ++i) values[space[i].name] = textOf(space[i], point[i]);
  return values;
}

std::string outputOf(const Study& study, const StudyCommand& command,
                     const std::map<std::string, std::string>& values, const Progress& progress) {
  ProgramCall call;
  call.scratch = values.at("folder");
  call.folder = study.folder;
  call.time_limit_s = study.commands->time_limit_s;
  for (const std::string& argument : command.arguments) call.arguments.push_back(filledIn(argument, values));
  if (call.arguments.front() == "lamina") call.arguments.front() = siblingProgram("lamina");
  const ProgramEnd end = runProgram(call, progress);
  if (end.exit_code != 0)
    throw InvalidInput("command " + command.name + " ended with exit code " + std::to_string(end.exit_code) +
                       ": " + tail(end.errors.empty() ? end.output : end.errors));
  return end.output;
}

double numberAt(const Json& json, const CommandResponse& response) {
  const Json::json_pointer pointer(response.pointer);
  const bool is_there = json.contains(pointer);
  if (!is_there || !json.at(pointer).is_number())
    throw InvalidInput("command " + response.command + ": at " + response.pointer + " stands " +
                       (is_there ? tail(json.at(pointer).dump()) : "nothing") + "; expected the number " +
                       response.name);
  return json.at(pointer).get<double>();
}

std::vector<double> measured(const Study& study, const DesignPoint& point, const Progress& progress) {
  const ScratchFolder folder;
  const auto values = valuesAt(study.variables, point, folder.path());
  std::map<std::string, std::string> outputs;
  for (const StudyCommand& command : study.commands->commands)
    outputs[command.name] = outputOf(study, command, values, progress);
  std::vector<double> responses;
  for (const CommandResponse& response : study.commands->responses) {
    const Json json = Json::parse(outputs.at(response.command), nullptr, false);
    if (json.is_discarded())
      throw InvalidInput("command " + response.command +
                         " prints no JSON: " + tail(outputs.at(response.command)));
    responses.push_back(numberAt(json, response));
  }
  return responses;
}

}  // namespace

PointMeasurement commandMeasurement(const Study& study) {
  return [study](const DesignPoint& point, Progress& progress) { return measured(study, point, progress); };
}

}  // namespace lamina
