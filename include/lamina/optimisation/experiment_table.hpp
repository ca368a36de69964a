// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// Points that were measured by experiment, with their responses.
struct ExperimentTable {
  std::vector<std::string> response_names;
  /// Points of the design of experiments, in the order of the file. A response that is missing is not a
  /// number.
  std::vector<Evaluation> design;
  /// Points that a search proposed: rows with a number in the column `iteration`, in the order of these
  /// numbers.
  std::vector<Evaluation> proposed;
};

/// Reads a table (.csv): a column for each variable and each response, and one named `iteration` if points
/// were measured after a search proposed them. Other columns are ignored. An empty cell is a missing
/// response.
/// @throws FileError; InvalidInput naming file, line and column if a column is missing, a cell is no number
///   or none of the variable's values, or an iteration is no whole number from 1 or stands twice
ExperimentTable readExperimentTable(const std::string& path, const DesignSpace& space,
                                    const std::vector<std::string>& response_names);

/// The table as text that `readExperimentTable` reads. Missing and failed responses are left empty.
std::string experimentTableCsv(const DesignSpace& space, const ExperimentTable& table);

/// Whether two points are nearly the same: each continuous variable differs by at most `share` of its range,
/// and all others are equal.
bool isNear(const DesignSpace& space, const DesignPoint& a, const DesignPoint& b, double share);

/// An evaluator that returns measured rows, for replays and for experiments that are done by hand. A point
/// without a row, or whose row lacks a response, fails: it has yet to be measured.
class TableEvaluator final : public Evaluator {
 public:
  /// @param nearness  greatest difference of continuous variables between a row and the point, as a share of
  ///   their ranges, since machines are set to rounded values. The nearest row is returned, each row only
  ///   once; the evaluation has the point of the row.
  TableEvaluator(DesignSpace space, std::vector<std::string> response_names, std::vector<Evaluation> rows,
                 double nearness);

  const std::vector<std::string>& responseNames() const override { return response_names_; }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

 private:
  Evaluation answerTo(const DesignPoint& point);

  DesignSpace space_;
  std::vector<std::string> response_names_;
  std::vector<Evaluation> rows_;
  std::vector<bool> is_used_;
  double nearness_;
};

}  // namespace lamina
