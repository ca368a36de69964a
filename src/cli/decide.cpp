// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "arguments/setting_options.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/optimisation/criteria.hpp"
#include "lamina/optimisation/front_csv.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina decide` as it was typed.
struct DecideArguments {
  std::string front;
  std::vector<std::string> weights;  ///< name=weight
  std::vector<std::string> maximised;
  std::string method = "linmap";
  std::string output;
  std::string base;
};

/// A front, how its responses count, and what was chosen.
struct Choice {
  FrontTable front;
  std::vector<Criterion> criteria;
  Decision decision;

  const FrontRow& row() const { return front.rows[decision.chosen]; }
};

Choice choiceOf(const DecideArguments& arguments) {
  const DecisionMethod method = decisionMethodOf(arguments.method);
  Choice choice;
  choice.front = readFrontCsv(arguments.front);
  choice.criteria = criteriaOf(choice.front.responses, overridesFrom(arguments.weights), arguments.maximised);
  std::vector<std::vector<double>> responses;
  for (const FrontRow& row : choice.front.rows) responses.push_back(row.responses);
  choice.decision = decide(choice.criteria, responses, method);
  return choice;
}

/// The values of the variables in the row chosen, over the settings of the base.
std::string configOf(const Choice& choice, const std::string& base) {
  std::vector<SettingText> settings;
  if (!base.empty()) settings = settingsFromYaml(readFile(base, kMostSettingsBytes), base);
  for (std::size_t i = 0; i < choice.front.variables.size(); ++i)
    settings.push_back({choice.front.variables[i], choice.row().values[i]});
  return settingsToYaml(settings);
}

nlohmann::ordered_json numberOrNull(double number) {
  if (std::isfinite(number)) return number;
  return nullptr;
}

void printJson(const Choice& choice, const std::string& method) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < choice.front.variables.size(); ++i)
    variables[choice.front.variables[i]] = choice.row().values[i];
  nlohmann::ordered_json responses;
  nlohmann::ordered_json weights;
  nlohmann::ordered_json maximised = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < choice.criteria.size(); ++i) {
    const Criterion& criterion = choice.criteria[i];
    responses[criterion.response] = numberOrNull(choice.row().responses[i]);
    weights[criterion.response] = criterion.weight;
    if (criterion.sense == Sense::Maximise) maximised.push_back(criterion.response);
  }
  const nlohmann::ordered_json json = {{"method", method},
                                       {"weights", weights},
                                       {"maximised", maximised},
                                       {"alternatives", choice.front.rows.size()},
                                       {"chosen", choice.decision.chosen + 1},
                                       {"line", choice.row().line},
                                       {"index", choice.decision.indices[choice.decision.chosen]},
                                       {"variables", variables},
                                       {"responses", responses},
                                       {"indices", choice.decision.indices}};
  std::printf("%s\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

void printText(const Choice& choice, const std::string& method) {
  std::printf("chosen       %zu of %zu, line %zu, by %s, index %.6g\n", choice.decision.chosen + 1,
              choice.front.rows.size(), choice.row().line, method.c_str(),
              choice.decision.indices[choice.decision.chosen]);
  for (std::size_t i = 0; i < choice.front.variables.size(); ++i)
    std::printf("%-32s %14s\n", choice.front.variables[i].c_str(), choice.row().values[i].c_str());
  for (std::size_t i = 0; i < choice.criteria.size(); ++i) {
    double least = choice.row().responses[i];
    double greatest = least;
    for (const FrontRow& row : choice.front.rows) {
      least = std::fmin(least, row.responses[i]);
      greatest = std::fmax(greatest, row.responses[i]);
    }
    std::printf("%-32s %14.6g  of %.6g to %.6g, weight %g%s\n", choice.criteria[i].response.c_str(),
                choice.row().responses[i], least, greatest, choice.criteria[i].weight,
                choice.criteria[i].sense == Sense::Maximise ? ", maximised" : "");
  }
}

void decideOn(const DecideArguments& arguments, OutputFormat format) {
  requireSuffix(arguments.output, {".yaml", ".yml"});
  requireApart({arguments.output}, {arguments.front, arguments.base});
  const Choice choice = choiceOf(arguments);
  const std::string config = configOf(choice, arguments.base);
  if (!arguments.output.empty()) writeFile(arguments.output, config);
  format == OutputFormat::Json ? printJson(choice, arguments.method) : printText(choice, arguments.method);
}

}  // namespace

void addDecide(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand("decide", kDecideDescription);
  const auto arguments = std::make_shared<DecideArguments>();
  subcommand->add_option("front", arguments->front, "Front (.csv): variables, then responses")->required();
  subcommand
      ->add_option("--weights", arguments->weights,
                   "Weights of responses as name=number, with commas between; those not named keep 1, "
                   "under_fill_mm2 and volume_error_mm3 keep 3; 0 for what is not to count")
      ->delimiter(',')
      ->allow_extra_args(false);
  subcommand
      ->add_option("--maximise", arguments->maximised, "Response of which more is better; may be repeated")
      ->delimiter(',')
      ->allow_extra_args(false);
  subcommand
      ->add_option("--method", arguments->method,
                   "linmap: nearest to the ideal; topsis: far from the worst too")
      ->check(CLI::IsMember({"linmap", "topsis"}))
      ->capture_default_str();
  subcommand->add_option("-o,--output", arguments->output,
                         "Settings (YAML) to write: the variables of the point chosen");
  subcommand->add_option("--base", arguments->base, "Settings (YAML) that are written with them");
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { decideOn(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
