// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// What somebody measured, row by row.
struct ExperimentTable {
  std::vector<std::string> response_names;
  /// Points of the design of experiments, in the order of the file. A response that is missing is not a
  /// number.
  std::vector<Evaluation> design;
  /// Points that a search proposed: rows with something in the column `iteration`, in the order of its
  /// numbers.
  std::vector<Evaluation> proposed;
};

/// Reads a table (.csv): a column for each variable and each response, and one named `iteration` if points
/// were measured after a search proposed them. Other columns are ignored. Empty cells of responses are
/// missing.
/// @throws FileError; InvalidInput naming file, line and column if a column is missing, a cell is no number
///   or none of the variable's values, or an iteration is no whole number from 1 or stands twice
ExperimentTable readExperimentTable(const std::string& path, const DesignSpace& space,
                                    const std::vector<std::string>& response_names);

/// The table as text, as it is read. Missing and failed responses are left empty.
std::string experimentTableCsv(const DesignSpace& space, const ExperimentTable& table);

/// Whether two points are the same, but for that share of the range of each continuous variable.
bool isNear(const DesignSpace& space, const DesignPoint& a, const DesignPoint& b, double share);

/// Answers from rows that were measured, for replays and for experiments that a person does. A point that is
/// in no row, or whose row lacks a response, fails: somebody has to measure it.
class TableEvaluator final : public Evaluator {
 public:
  /// @param nearness  how far a row's continuous variables may lie from what was asked for, as a share of
  ///   their ranges: machines are set to rounded values. The nearest row answers, and only once; the answer
  ///   says where it was measured.
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
