// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/study/study_job.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/study/study_reader.hpp"
#include "output/terminal_progress.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina optimise` as it was typed.
struct OptimiseArguments {
  std::string study;
  std::string output;
  std::string part;
  std::vector<std::string> assignments;
  EarlierJournal earlier = EarlierJournal::GoOn;
};

/// A line on standard error for each generation or iteration.
void print(const Study& study, const StudyState& state) {
  std::string best;
  for (std::size_t i = 0; i < state.best.size(); ++i)
    best += "  " + study.goals.objectives[i].response + " " + numberText(state.best[i]);
  const bool is_front = study.method == SearchMethod::Nsga2;
  if (::isatty(STDERR_FILENO) != 0) std::fputs("\r\x1b[K", stderr);
  std::fprintf(stderr, "%s %d: %d evaluations, %d failed%s%s%s\n", is_front ? "generation" : "iteration",
               state.index, state.evaluations, state.failed,
               is_front ? (", hypervolume " + numberText(state.hypervolume)).c_str() : "",
               best.empty() ? "" : "; best so far", best.c_str());
}

nlohmann::ordered_json jsonOf(const std::vector<SettingText>& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const SettingText& value : values) json[value.key] = value.text;
  return json;
}

nlohmann::ordered_json jsonOf(const DesignSpace& space, const std::vector<std::string>& names,
                              const Evaluation& evaluation) {
  nlohmann::ordered_json json = {{"variables", nlohmann::ordered_json::object()},
                                 {"responses", nlohmann::ordered_json::object()}};
  for (std::size_t i = 0; i < space.size(); ++i) {
    const double value = evaluation.point[i];
    if (space[i].kind == VariableKind::Categorical)
      json["variables"][space[i].name] = textOf(space[i], value);
    else
      json["variables"][space[i].name] = value;
  }
  for (std::size_t i = 0; i < names.size(); ++i) json["responses"][names[i]] = evaluation.responses.at(i);
  return json;
}

/// What was proposed, expected, and measured; numbers that are not there are null.
nlohmann::ordered_json jsonOf(const Study& study, const std::vector<std::string>& names,
                              const SurrogateIteration& iteration) {
  const auto number = [](double value) -> nlohmann::ordered_json {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json json = {{"proposed", nlohmann::ordered_json::object()},
                                 {"measured_at", nlohmann::ordered_json::object()},
                                 {"responses", nlohmann::ordered_json::object()}};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const Variable& variable = study.variables[i];
    json["proposed"][variable.name] = textOf(variable, iteration.proposed[i]);
    json["measured_at"][variable.name] = textOf(variable, iteration.measured.point.at(i));
  }
  const Evaluation& measured = iteration.measured;
  for (std::size_t k = 0; k < names.size(); ++k)
    json["responses"][names[k]] = {
        {"predicted", number(iteration.predictions.at(k).value)},
        {"deviation", number(std::sqrt(iteration.predictions[k].variance))},
        {"measured", isEvaluated(measured) ? number(measured.responses.at(k)) : nullptr}};
  json["mape_percent"] = number(iteration.mape_percent);
  json["is_feasible"] = iteration.is_feasible;
  json["is_sample"] = iteration.is_sample;
  json["is_accepted"] = iteration.is_accepted;
  json["error"] = measured.error;
  return json;
}

void printProposal(const Study& study, const std::vector<std::string>& names,
                   const SurrogateIteration& iteration) {
  std::string point;
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const Variable& variable = study.variables[i];
    const double value = iteration.proposed[i];
    const bool is_number = variable.kind != VariableKind::Categorical;
    point += "  " + variable.name + " " + (is_number ? numberText(value) : textOf(variable, value));
  }
  const bool is_measured = isEvaluated(iteration.measured);
  std::printf("proposal %zu:%s\n", iteration.index, point.c_str());
  for (std::size_t k = 0; k < names.size(); ++k)
    std::printf("  %-34s %s predicted, %s measured\n", names[k].c_str(),
                numberText(iteration.predictions.at(k).value).c_str(),
                is_measured ? numberText(iteration.measured.responses.at(k)).c_str() : "not");
  if (is_measured)
    std::printf("  error of predictions %.2f %%, %s\n", iteration.mape_percent,
                iteration.is_sample     ? "a sample already"
                : iteration.is_accepted ? "accepted"
                : iteration.is_feasible ? "predicted too badly to be accepted"
                                        : "outside an interval");
}

void printJson(const Study& study, const StudyOutcome& outcome, const StudyFiles& files) {
  nlohmann::ordered_json json = {{"study", study.name},
                                 {"evaluations", outcome.evaluations.size()},
                                 {"failed", failedCount(outcome.evaluations)},
                                 {"front_size", outcome.front.size()},
                                 {"chosen", nullptr}};
  if (outcome.chosen) json["chosen"] = jsonOf(study.variables, outcome.front_response_names, *outcome.chosen);
  if (!outcome.generations.empty()) json["hypervolume"] = outcome.generations.back().hypervolume;
  if (outcome.surrogate) {
    json["iterations"] = outcome.surrogate->iterations.size();
    json["end"] = toString(outcome.surrogate->end);
    json["proposals"] = nlohmann::ordered_json::array();
    for (const SurrogateIteration& iteration : outcome.surrogate->iterations)
      json["proposals"].push_back(jsonOf(study, outcome.response_names, iteration));
  }
  json["compared"] = nlohmann::ordered_json::object();
  for (const ComparedRow& row : outcome.compared) json["compared"][row.name] = jsonOf(row.values);
  json["notes"] = outcome.notes;
  json["wall_s"] = outcome.wall_s;
  json["report"] = files.report;
  json["configuration"] = outcome.chosen ? files.chosen : "";
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

void printText(const Study& study, const StudyOutcome& outcome, const StudyFiles& files) {
  std::printf("%s: %zu evaluations, %zu failed, in %.1f s\n", study.name.c_str(), outcome.evaluations.size(),
              failedCount(outcome.evaluations), outcome.wall_s);
  if (!outcome.front.empty()) std::printf("front: %zu configurations\n", outcome.front.size());
  if (outcome.surrogate) {
    for (const SurrogateIteration& iteration : outcome.surrogate->iterations)
      printProposal(study, outcome.response_names, iteration);
    std::printf("proposed: %zu points; ended: %s\n", outcome.surrogate->iterations.size(),
                toString(outcome.surrogate->end));
  }
  if (!outcome.chosen && outcome.front.empty()) std::printf("nothing keeps to all constraints\n");
  if (outcome.chosen)
    for (const SettingText& value : valuesOf(study.variables, outcome.front_response_names, *outcome.chosen))
      std::printf("  %-34s %s\n", value.key.c_str(), value.text.c_str());
  for (const std::string& note : outcome.notes) std::printf("note: %s\n", note.c_str());
  std::printf("report: %s\n", files.report.c_str());
}

void optimise(const OptimiseArguments& arguments, OutputFormat format) {
  StudyJob job;
  job.study = readStudyFile(arguments.study);
  if (!arguments.part.empty()) job.study = ofPart(std::move(job.study), arguments.part);
  for (const SettingText& setting : overridesFrom(arguments.assignments)) job.study.search.push_back(setting);
  job.output = arguments.output;
  job.earlier = arguments.earlier;
  const SurrogateFit fit = krigingFit(surrogateFitSettingsOf(job.study));
  TerminalProgress progress;
  const auto hear = [&](const StudyState& state) { print(job.study, state); };
  const StudyOutcome outcome = runStudy(job, fit, nullptr, hear, progress);
  const StudyFiles files = studyFilesIn(job.output);
  format == OutputFormat::Json ? printJson(job.study, outcome, files) : printText(job.study, outcome, files);
}

}  // namespace

void addOptimise(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("optimise", kOptimiseDescription);
  const auto arguments = std::make_shared<OptimiseArguments>();
  subcommand->add_option("study", arguments->study, "What is searched for, how, and what measures it (.yaml)")
      ->required();
  subcommand
      ->add_option("-o,--output", arguments->output,
                   "Folder for journal, front, evaluations, chosen configuration and report")
      ->required();
  subcommand->add_option("--part", arguments->part, "Mesh file or name of a part, instead of the study's");
  subcommand
      ->add_option("--set", arguments->assignments,
                   "One setting of the search as key=value (nsga2.*, surrogate.*, genetic.*, kriging.*); may "
                   "be repeated")
      ->allow_extra_args(false);
  CLI::Option* fresh = subcommand->add_flag_callback(
      "--fresh", [arguments] { arguments->earlier = EarlierJournal::BeginAnew; },
      "Begin anew instead of going on with the journal in the folder");
  subcommand
      ->add_flag_callback(
          "--retry-failed", [arguments] { arguments->earlier = EarlierJournal::RetryFailed; },
          "Go on with the journal in the folder, but try again what failed")
      ->excludes(fresh);
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { optimise(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
