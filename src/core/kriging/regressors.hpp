// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "lamina/optimisation/design_space.hpp"

namespace lamina {

/// What kriging sees of a design point: numbers of mean 0 and standard deviation 1 over the samples.
/// Variables with an order are one column; a Categorical one of two choices too, one of more is an indicator
/// column for each choice. Columns that no sample changes are left out.
class Regressors {
 public:
  /// @param points  at least two, all different
  /// @throws InvalidInput if they are not
  Regressors(const DesignSpace& space, const std::vector<DesignPoint>& points);

  std::size_t columns() const { return columns_.size(); }
  Eigen::VectorXd of(const DesignPoint& point) const;

  /// The variable behind a column and, of an indicator, its choice.
  std::string nameOf(const DesignSpace& space, std::size_t column) const;

  /// Products of columns that make up a polynomial: (-1, -1) is the constant, (-1, i) column i, (i, j) the
  /// product. Of the indicators of a variable the last one is left out, and so are their squares.
  std::vector<std::pair<int, int>> polynomial(int order) const;

 private:
  struct Column {
    std::size_t variable;
    int choice;  ///< -1 for the value itself
    bool is_redundant;
    double mean;
    double deviation;
  };

  double rawValue(const Column& column, const DesignPoint& point) const;

  std::vector<Column> columns_;
};

}  // namespace lamina
