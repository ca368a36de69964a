// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "lamina/base/atomic_file.hpp"
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

/// Comma-separated cells under a header; lines that begin with # are none.
class Table {
 public:
  explicit Table(const std::string& path) : path_(path) {
    std::istringstream text(readFile(path));
    for (std::string line; std::getline(text, line);) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.empty() || line[0] == '#') continue;
      std::vector<std::string> cells;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
      if (header_.empty()) {
        header_ = std::move(cells);
        continue;
      }
      rows_.push_back(std::move(cells));
      if (rows_.back().size() != header_.size())
        throw InvalidInput("'" + path + "' row " + std::to_string(rows_.size()) + " has " +
                           std::to_string(rows_.back().size()) + " cells; must have " +
                           std::to_string(header_.size()));
    }
  }

  std::vector<std::string> column(const std::string& name) const {
    const auto found = std::find(header_.begin(), header_.end(), name);
    if (found == header_.end())
      throw InvalidInput("'" + path_ + "' has no column '" + name + "'; it has " + listed(header_, ", "));
    std::vector<std::string> cells;
    for (const auto& row : rows_) cells.push_back(row[static_cast<std::size_t>(found - header_.begin())]);
    return cells;
  }

  std::vector<double> numbers(const std::string& name) const {
    std::vector<double> values;
    for (const std::string& cell : column(name)) {
      char* end = nullptr;
      values.push_back(std::strtod(cell.c_str(), &end));
      if (cell.empty() || *end != '\0')
        throw InvalidInput("'" + path_ + "' column '" + name + "' holds '" + cell + "'; must be a number");
    }
    return values;
  }

 private:
  std::string path_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

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
  const Table table(arguments.table);
  const std::vector<double> response = table.numbers(arguments.response);
  std::vector<Factor> factors;
  for (const std::string& name : arguments.factors) factors.push_back({name, table.column(name)});
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
      "statistics", "Tell whether groups of a table differ: normality, ranks, analysis of variance");
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
