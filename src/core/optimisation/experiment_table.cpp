// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/experiment_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr const char* kIterationColumn = "iteration";

/// How numbers are read, and written.
const Variable kAnyNumber = {"",
                             VariableKind::Continuous,
                             std::numeric_limits<double>::lowest(),
                             std::numeric_limits<double>::max(),
                             {},
                             {}};

InvalidInput fault(const CsvTable& table, std::size_t row, const std::string& what) {
  return InvalidInput("'" + table.source + "' line " + std::to_string(table.lines[row]) + ": " + what);
}

double responseIn(const CsvTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows[row][column];
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  try {
    return valueOf(kAnyNumber, cell);
  } catch (const InvalidInput&) {
    throw fault(table, row,
                "response " + table.columns[column] + ": '" + cell + "'; expected a number or nothing");
  }
}

Evaluation evaluationIn(const CsvTable& table, std::size_t row, const DesignSpace& space,
                        const std::vector<std::string>& response_names) {
  Evaluation evaluation;
  for (const Variable& variable : space) {
    const std::string& cell = table.rows[row][columnOf(table, variable.name)];
    try {
      evaluation.point.push_back(valueOf(variable, cell));
    } catch (const InvalidInput& error) {
      throw fault(table, row, error.what());
    }
  }
  for (const std::string& name : response_names)
    evaluation.responses.push_back(responseIn(table, row, columnOf(table, name)));
  return evaluation;
}

/// 0 for a row of the design.
int iterationIn(const CsvTable& table, std::size_t row) {
  const auto column = std::find(table.columns.begin(), table.columns.end(), kIterationColumn);
  if (column == table.columns.end()) return 0;
  const std::string& cell = table.rows[row][static_cast<std::size_t>(column - table.columns.begin())];
  if (cell.empty()) return 0;
  const Variable counting = {kIterationColumn, VariableKind::Integer, 1.0, 1e6, {}, {}};
  try {
    return static_cast<int>(valueOf(counting, cell));
  } catch (const InvalidInput&) {
    throw fault(table, row, "iteration '" + cell + "'; expected a whole number from 1, or nothing");
  }
}

std::string csvLine(const DesignSpace& space, const Evaluation& evaluation, std::size_t response_count,
                    const std::string& iteration) {
  std::vector<std::string> cells = {iteration};
  for (std::size_t i = 0; i < space.size(); ++i)
    cells.push_back(csvCell(textOf(space[i], evaluation.point[i])));
  for (std::size_t k = 0; k < response_count; ++k) {
    const bool is_known = k < evaluation.responses.size() && std::isfinite(evaluation.responses[k]);
    cells.push_back(is_known ? textOf(kAnyNumber, evaluation.responses[k]) : "");
  }
  return listed(cells, ",") + "\n";
}

/// The greatest difference of two points as a share of a variable's range; infinite if a variable without
/// values in between differs.
double separation(const DesignSpace& space, const DesignPoint& a, const DesignPoint& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < space.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (space[i].kind != VariableKind::Continuous) return std::numeric_limits<double>::infinity();
    greatest = std::max(greatest, std::abs(a[i] - b[i]) / (space[i].high - space[i].low));
  }
  return greatest;
}

std::string described(const DesignSpace& space, const DesignPoint& point) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < space.size(); ++i)
    values.push_back(space[i].name + " " + textOf(space[i], point[i]));
  return listed(values);
}

}  // namespace

ExperimentTable readExperimentTable(const std::string& path, const DesignSpace& space,
                                    const std::vector<std::string>& response_names) {
  validate(space);
  const CsvTable table = readCsvTable(path);
  ExperimentTable read{response_names, {}, {}};
  std::map<int, Evaluation> proposed;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    Evaluation evaluation = evaluationIn(table, row, space, response_names);
    const int iteration = iterationIn(table, row);
    if (iteration == 0)
      read.design.push_back(std::move(evaluation));
    else if (!proposed.emplace(iteration, std::move(evaluation)).second)
      throw fault(table, row, "iteration " + std::to_string(iteration) + " stands twice");
  }
  for (auto& [iteration, evaluation] : proposed) read.proposed.push_back(std::move(evaluation));
  return read;
}

std::string experimentTableCsv(const DesignSpace& space, const ExperimentTable& table) {
  std::vector<std::string> columns = {kIterationColumn};
  for (const Variable& variable : space) columns.push_back(csvCell(variable.name));
  for (const std::string& name : table.response_names) columns.push_back(csvCell(name));
  std::string text = listed(columns, ",") + "\n";
  for (const Evaluation& evaluation : table.design)
    text += csvLine(space, evaluation, table.response_names.size(), "");
  for (std::size_t i = 0; i < table.proposed.size(); ++i)
    text += csvLine(space, table.proposed[i], table.response_names.size(), std::to_string(i + 1));
  return text;
}

bool isNear(const DesignSpace& space, const DesignPoint& a, const DesignPoint& b, double share) {
  return separation(space, a, b) <= share;
}

TableEvaluator::TableEvaluator(DesignSpace space, std::vector<std::string> response_names,
                               std::vector<Evaluation> rows, double nearness)
    : space_(std::move(space)),
      response_names_(std::move(response_names)),
      rows_(std::move(rows)),
      is_used_(rows_.size(), false),
      nearness_(nearness) {}

Evaluation TableEvaluator::answerTo(const DesignPoint& point) {
  std::size_t nearest = rows_.size();
  double least = nearness_;
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const double apart = separation(space_, point, rows_[row].point);
    if (is_used_[row] || apart > least || (nearest < rows_.size() && apart == least)) continue;
    least = apart;
    nearest = row;
  }
  if (nearest == rows_.size()) return {point, {}, "not in the table; measure " + described(space_, point)};
  is_used_[nearest] = true;
  const Evaluation& row = rows_[nearest];
  for (std::size_t k = 0; k < response_names_.size(); ++k)
    if (!std::isfinite(row.responses.at(k)))
      return {row.point, {}, "the table lacks " + response_names_[k] + " at " + described(space_, row.point)};
  return row;
}

std::vector<Evaluation> TableEvaluator::evaluate(const std::vector<DesignPoint>& points,
                                                 const EvaluationListener& done, Progress& progress) {
  std::vector<Evaluation> evaluations;
  for (const DesignPoint& point : points) {
    throwIfCancelled(progress, "evaluate");
    evaluations.push_back(answerTo(point));
    if (done) done(evaluations.back());
  }
  return evaluations;
}

}  // namespace lamina
