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

/// How a study is searched.
enum class SearchMethod {
  Nsga2,      ///< by NSGA-II, for a front of points none of which is better than another in all objectives
  Surrogate,  ///< for one point, by interpolation of the responses that is refined by new measurements
};

/// Settings that are measured for comparison with the result of the search.
struct Baseline {
  std::string name;
  std::vector<SettingText> settings;
};

/// Measurement by slicing a part in this program. The variables are keys of the configuration.
struct SliceMeasure {
  std::string part;                     ///< path of a mesh, or name of a part
  std::vector<SettingText> parameters;  ///< parameters of a part given by name
  std::string config;                   ///< path of a settings file; empty for none
  std::vector<SettingText> settings;    ///< settings that override those of the file
  std::vector<std::string> metrics;     ///< names of the metrics measured at each point
  /// Metrics measured once more for the front; empty for all metrics.
  std::vector<std::string> front_metrics;
  std::vector<Baseline> baselines;
};

/// A command: a program and its arguments, in which `{variable}` and `{folder}` are replaced.
struct StudyCommand {
  std::string name;
  std::vector<std::string> arguments;  ///< the program, and its arguments
};

/// A response that is read from the JSON that a command prints.
struct CommandResponse {
  std::string name;     ///< of the response
  std::string command;  ///< name of the command
  std::string pointer;  ///< JSON pointer to the number (RFC 6901): /porosity_percent
};

/// Measurement by commands, which are run one after the other for each point.
struct CommandMeasure {
  std::vector<StudyCommand> commands;
  std::vector<CommandResponse> responses;
  double time_limit_s = 3600.0;  ///< of each command
};

/// How one point of a front is chosen.
struct DecisionSettings {
  std::string method = "linmap";     ///< "linmap" or "topsis"
  std::vector<SettingText> weights;  ///< weights by response; for responses without one see `criteriaOf`
};

/// Published values of variables and responses, for comparison.
struct PublishedRow {
  std::string name;
  std::vector<SettingText> values;
};

/// A study: an optimisation problem, and how it is solved, as read from a file. Exactly one of `slice`,
/// `commands` and `table` alone measures the points.
struct Study {
  std::string name;
  std::string about;   ///< free text
  std::string file;    ///< path of the file from which it was read; empty if read from a text
  std::string folder;  ///< folder of that file, in which commands are run; empty for the current one
  SearchMethod method = SearchMethod::Nsga2;
  DesignSpace variables;
  std::optional<SliceMeasure> slice;
  std::optional<CommandMeasure> commands;
  std::string table;  ///< path of a CSV table of experiments that were made by hand; empty for none
  Goals goals;
  std::vector<SettingText> search;  ///< settings nsga2.*, surrogate.*, kriging.*; of one key the last counts
  DecisionSettings decision;
  std::string published_source;  ///< source of the values in `published`
  std::vector<PublishedRow> published;
};

/// The names of the responses that are measured at each point, in their order: metrics, responses of
/// commands, or, without these, the responses that the goals name.
std::vector<std::string> responseNames(const Study& study);

/// The study applied to another part, without published values, which are of the original part.
/// @param part  path of a mesh, or name of a part
/// @throws InvalidConfig if the study slices no part
Study ofPart(Study study, const std::string& part);

}  // namespace lamina
