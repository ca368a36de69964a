// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// How the variables are searched.
enum class SearchMethod {
  Nsga2,      ///< a front of points, none of which is better in all objectives
  Surrogate,  ///< one point, found on interpolations of the responses and measured again and again
};

/// Settings by name, to be measured beside what the search finds.
struct Baseline {
  std::string name;
  std::vector<SettingText> settings;
};

/// Measures by slicing a part in this program. Variables are keys of the configuration.
struct SliceMeasure {
  std::string part;                        ///< mesh file or name of a part
  std::vector<SettingText> parameters;     ///< of a named part
  std::string config;                      ///< settings file; empty for none
  std::vector<SettingText> settings;       ///< over those of the file
  std::vector<std::string> metrics;        ///< measured at each point
  std::vector<std::string> front_metrics;  ///< measured again for the front; empty for all there are
  std::vector<Baseline> baselines;
};

/// A program and its arguments, which may hold `{variable}` and `{folder}`.
struct StudyCommand {
  std::string name;
  std::vector<std::string> arguments;  ///< the first is the program
};

/// A number in the JSON that a command prints.
struct CommandResponse {
  std::string name;
  std::string command;
  std::string pointer;  ///< RFC 6901: /porosity_percent
};

/// Measures by programs, run one after the other for each point.
struct CommandMeasure {
  std::vector<StudyCommand> commands;
  std::vector<CommandResponse> responses;
  double time_limit_s = 3600.0;  ///< of each command
};

/// How one point of a front is chosen.
struct DecisionWishes {
  std::string method = "linmap";     ///< linmap | topsis
  std::vector<SettingText> weights;  ///< by response, numbers; of others see `criteriaOf`
};

/// Values that somebody published: of variables and responses, as text.
struct PublishedRow {
  std::string name;
  std::vector<SettingText> values;
};

/// The subject of a search, as a person writes it down.
struct Study {
  std::string name;
  std::string about;   ///< free text
  std::string file;    ///< that it was read from; empty if from a text
  std::string folder;  ///< of the file; commands run in it; empty for the current one
  SearchMethod method = SearchMethod::Nsga2;
  DesignSpace variables;
  std::optional<SliceMeasure> slice;
  std::optional<CommandMeasure> commands;
  std::string table;  ///< experiments that somebody made and typed in (CSV); empty for none
  Goals goals;
  std::vector<SettingText> search;  ///< nsga2.*, surrogate.*, kriging.*; the last of a key counts
  DecisionWishes decision;
  std::string published_source;
  std::vector<PublishedRow> published;
};

/// What is measured at each point, in order: metrics, responses of commands, or, where there is but a table,
/// what the goals name.
std::vector<std::string> responseNames(const Study& study);

/// The same study of another part; what was published is of the part it was written for, and left out.
/// @param part  mesh file or name of a part
/// @throws InvalidConfig if the study slices no part
Study ofPart(Study study, const std::string& part);

}  // namespace lamina
