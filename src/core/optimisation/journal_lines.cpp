// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "journal_lines.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kJournalInfinity = std::numeric_limits<double>::infinity();

std::string dumped(const Json& json) {
  // Messages of failures may hold any bytes.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json parsed(const std::string& line) {
  try {
    return Json::parse(line);
  } catch (const Json::exception&) {
    throw InvalidInput("is no JSON");
  }
}

Json toJson(const Variable& variable) {
  const char* kinds[] = {"continuous", "integer", "levels", "categorical"};
  Json json = {{"name", variable.name}, {"kind", kinds[static_cast<int>(variable.kind)]}};
  switch (variable.kind) {
    case VariableKind::Continuous:
    case VariableKind::Integer:
      json["low"] = variable.low;
      json["high"] = variable.high;
      break;
    case VariableKind::Levels:
      json["levels"] = variable.levels;
      break;
    case VariableKind::Categorical:
      json["choices"] = variable.choices;
      break;
  }
  return json;
}

/// JSON has no numbers that are not finite.
Json toJson(double number) {
  if (std::isfinite(number)) return number;
  if (std::isnan(number)) return "nan";
  return number > 0.0 ? "inf" : "-inf";
}

double numberOf(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return kJournalInfinity;
  if (json == "-inf") return -kJournalInfinity;
  throw InvalidInput("has " + dumped(json) + " where a number was expected");
}

double valueOf(const Variable& variable, const Json& json) {
  if (variable.kind != VariableKind::Categorical) return numberOf(json);
  if (!json.is_string()) throw InvalidInput("has " + dumped(json) + " for " + variable.name);
  return lamina::valueOf(variable, json.get<std::string>());
}

const Json& memberOf(const Json& json, const char* name, std::size_t size) {
  if (!json.is_object() || !json.contains(name) || !json[name].is_array())
    throw InvalidInput("has no list '" + std::string(name) + "'");
  if (json[name].size() != size)
    throw InvalidInput("has " + std::to_string(json[name].size()) + " numbers in '" + name + "'; expected " +
                       std::to_string(size));
  return json[name];
}

}  // namespace

JournalLines::JournalLines(const DesignSpace& space, const std::vector<std::string>& response_names,
                           const std::string& fingerprint)
    : space_(space), response_names_(response_names) {
  Json json = {{"lamina_journal", 1}, {"fingerprint", fingerprint}, {"variables", Json::array()}};
  for (const Variable& variable : space) json["variables"].push_back(toJson(variable));
  json["responses"] = response_names;
  header_ = dumped(json);
}

void JournalLines::requireHeader(const std::string& line) const {
  if (line == header_) return;
  const Json theirs = parsed(line);
  if (!theirs.is_object() || !theirs.contains("lamina_journal"))
    throw InvalidInput("is no header of a journal");
  const Json ours = Json::parse(header_);
  for (const auto& [key, value] : ours.items())
    if (!theirs.contains(key) || theirs[key] != value)
      throw InvalidInput("belongs to another study: " + key + " " +
                         (theirs.contains(key) ? dumped(theirs[key]) : "missing") + "; expected " +
                         dumped(value));
}

std::string JournalLines::lineOf(const Evaluation& evaluation) const {
  Json json = {{"point", Json::array()}};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    const bool is_choice = space_[i].kind == VariableKind::Categorical;
    json["point"].push_back(is_choice ? Json(textOf(space_[i], evaluation.point[i]))
                                      : toJson(evaluation.point[i]));
  }
  if (isEvaluated(evaluation)) {
    json["responses"] = Json::array();
    for (const double response : evaluation.responses) json["responses"].push_back(toJson(response));
  } else {
    json["error"] = evaluation.error;
  }
  return dumped(json);
}

Evaluation JournalLines::evaluationOf(const std::string& line) const {
  const Json json = parsed(line);
  Evaluation evaluation;
  const Json& point = memberOf(json, "point", space_.size());
  for (std::size_t i = 0; i < space_.size(); ++i) evaluation.point.push_back(valueOf(space_[i], point[i]));
  requireWithin(space_, evaluation.point);
  if (json.contains("error")) {
    if (!json["error"].is_string() || json["error"] == "" || json.contains("responses"))
      throw InvalidInput("has an error that is no text, or responses beside it");
    evaluation.error = json["error"].get<std::string>();
    return evaluation;
  }
  for (const Json& response : memberOf(json, "responses", response_names_.size()))
    evaluation.responses.push_back(numberOf(response));
  return evaluation;
}

}  // namespace lamina
