// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"
#include "lamina/statistics/analysis_of_variance.hpp"
#include "lamina/statistics/kolmogorov_smirnov.hpp"
#include "lamina/statistics/kruskal_wallis.hpp"
#include "subcommand.hpp"

namespace lamina::cli {
namespace {

/// The command line of `lamina statistics` as it was typed.
struct StatisticsArguments {
  std::string table;
  std::string response;
  std::vector<std::string> factors;
};

std::vector<std::string> columnNamed(const CsvTable& table, const std::string& name) {
  const std::size_t column = columnOf(table, name);
  std::vector<std::string> cells;
  cells.reserve(table.rows.size());
  for (const auto& row : table.rows) cells.push_back(row[column]);
  return cells;
}

std::vector<double> numbersOf(const CsvTable& table, const std::string& name) {
  std::vector<double> values;
  for (const std::string& cell : columnNamed(table, name)) {
    char* end = nullptr;
    values.push_back(std::strtod(cell.c_str(), &end));
    if (cell.empty() || *end != '\0')
      throw InvalidInput("'" + table.source + "' column '" + name + "' holds '" + cell +
                         "'; must be a number");
  }
  return values;
}

/// Values of equal levels of all factors.
std::map<std::string, std::vector<double>> groupsOf(const std::vector<double>& response,
                                                    const std::vector<Factor>& factors) {
  std::map<std::string, std::vector<double>> groups;
  for (std::size_t row = 0; row < response.size(); ++row) {
    std::vector<std::string> levels;
    levels.reserve(factors.size());
    for (const Factor& factor : factors) levels.push_back(factor.levels[row]);
    groups[listed(levels, ", ")].push_back(response[row]);
  }
  return groups;
}

nlohmann::ordered_json normalityOf(const std::vector<double>& values) {
  if (values.size() < 2)
    throw InvalidInput("there are " + std::to_string(values.size()) + " values; must be at least 2");
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double deviation = std::sqrt(squares / (n - 1.0));
  return {{"values", values.size()},
          {"mean", mean},
          {"deviation", deviation},
          {"p_standard_normal", testNormality(values, 0.0, 1.0).probability},
          {"p_normal", testNormality(values, mean, deviation).probability}};
}

nlohmann::ordered_json ranksOf(const std::map<std::string, std::vector<double>>& groups) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  for (const auto& [name, group] : groups) {
    names.push_back(name);
    values.push_back(group);
  }
  const KruskalWallis test = testRanks(values);
  nlohmann::ordered_json pairs = nlohmann::json::array();
  for (const RankComparison& pair : test.comparisons)
    pairs.push_back({{"first", names[pair.first]},
                     {"second", names[pair.second]},
                     {"rank_difference", pair.difference},
                     {"p", pair.probability}});
  return {{"h", test.h},
          {"degrees_of_freedom", test.degrees_of_freedom},
          {"p", test.probability},
          {"comparisons", pairs}};
}

nlohmann::ordered_json varianceOf(const std::vector<double>& response, const std::vector<Factor>& factors) {
  const AnalysisOfVariance analysis = analyseVariance(response, factors);
  nlohmann::ordered_json sources = nlohmann::json::array();
  for (const VarianceSource& source : analysis.sources)
    sources.push_back({{"source", source.name},
                       {"sum_of_squares", source.sum_of_squares},
                       {"degrees_of_freedom", source.degrees_of_freedom},
                       {"f", source.f},
                       {"p", source.probability}});
  return {{"sources", sources},
          {"residual_sum_of_squares", analysis.residual_sum_of_squares},
          {"residual_degrees_of_freedom", analysis.residual_degrees_of_freedom}};
}

void printText(const nlohmann::ordered_json& json) {
  const auto& normality = json["normality"];
  std::printf("normality    %zu values, p %.6g against their mean and deviation\n",
              normality["values"].get<std::size_t>(), normality["p_normal"].get<double>());
  const auto& ranks = json["kruskal_wallis"];
  std::printf("ranks        H %.6g, p %.6g, %zu pairs compared\n", ranks["h"].get<double>(),
              ranks["p"].get<double>(), ranks["comparisons"].size());
  for (const auto& source : json["variance"]["sources"])
    std::printf("variance     %-32s F %.6g, p %.6g\n", source["source"].get<std::string>().c_str(),
                source["f"].get<double>(), source["p"].get<double>());
}

void statistics(const StatisticsArguments& arguments, OutputFormat format) {
  const CsvTable table = readCsvTable(arguments.table);
  const std::vector<double> response = numbersOf(table, arguments.response);
  std::vector<Factor> factors;
  for (const std::string& name : arguments.factors) factors.push_back({name, columnNamed(table, name)});
  const nlohmann::ordered_json json = {{"normality", normalityOf(response)},
                                       {"kruskal_wallis", ranksOf(groupsOf(response, factors))},
                                       {"variance", varianceOf(response, factors)}};
  if (format == OutputFormat::Json)
    std::printf("%s\n", json.dump(2).c_str());
  else
    printText(json);
}

}  // namespace

void addStatistics(CLI::App& app, Chosen& chosen) {
  CLI::App* subcommand = app.add_subcommand(
      "statistics", "Report whether groups of a table differ: normality, ranks, analysis of variance");
  const auto arguments = std::make_shared<StatisticsArguments>();
  subcommand->add_option("table", arguments->table, "Table (.csv) with a header")->required();
  subcommand->add_option("--response", arguments->response, "Column of the values")->required();
  subcommand->add_option("--factors", arguments->factors, "Columns of what may make them differ")
      ->delimiter(',')
      ->required();
  addJsonFlag(*subcommand, chosen);
  subcommand->callback(
      [arguments, &chosen] { chosen.run = [arguments, &chosen] { statistics(*arguments, chosen.format); }; });
}

}  // namespace lamina::cli
