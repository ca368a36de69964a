// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kriging/regressors.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {

Regressors::Regressors(const DesignSpace& space, const std::vector<DesignPoint>& points) {
  if (std::set<DesignPoint>(points.begin(), points.end()).size() != points.size() || points.size() < 2)
    throw InvalidInput("kriging of " + std::to_string(points.size()) +
                       " samples; expected at least 2 at different points");
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool has_indicators = space[i].kind == VariableKind::Categorical && space[i].choices.size() > 2;
    const int count = has_indicators ? static_cast<int>(space[i].choices.size()) : 1;
    for (int choice = 0; choice < count; ++choice)
      columns_.push_back({i, has_indicators ? choice : -1, has_indicators && choice + 1 == count, 0.0, 0.0});
  }
  const auto n = static_cast<double>(points.size());
  for (Column& column : columns_) {
    for (const DesignPoint& point : points) column.mean += rawValue(column, point) / n;
    double squares = 0.0;
    for (const DesignPoint& point : points) squares += std::pow(rawValue(column, point) - column.mean, 2.0);
    const double range = highOf(space[column.variable]) - lowOf(space[column.variable]);
    column.deviation = std::sqrt(squares / (n - 1.0));
    if (column.deviation < 1e-12 * range) column.deviation = 0.0;
  }
  const auto is_constant = [](const Column& column) { return column.deviation == 0.0; };
  columns_.erase(std::remove_if(columns_.begin(), columns_.end(), is_constant), columns_.end());
}

double Regressors::rawValue(const Column& column, const DesignPoint& point) const {
  const double value = point.at(column.variable);
  return column.choice < 0 ? value : static_cast<double>(value == column.choice);
}

Eigen::VectorXd Regressors::of(const DesignPoint& point) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(columns_.size()));
  for (std::size_t c = 0; c < columns_.size(); ++c)
    values[static_cast<Eigen::Index>(c)] =
        (rawValue(columns_[c], point) - columns_[c].mean) / columns_[c].deviation;
  return values;
}

std::string Regressors::nameOf(const DesignSpace& space, std::size_t column) const {
  const Variable& variable = space[columns_[column].variable];
  const int choice = columns_[column].choice;
  return choice < 0 ? variable.name
                    : variable.name + "=" + variable.choices[static_cast<std::size_t>(choice)];
}

std::vector<std::pair<int, int>> Regressors::polynomial(int order) const {
  std::vector<std::pair<int, int>> terms = {{-1, -1}};
  if (order < 1) return terms;
  const auto count = static_cast<int>(columns_.size());
  for (int i = 0; i < count; ++i)
    if (!columns_[static_cast<std::size_t>(i)].is_redundant) terms.emplace_back(-1, i);
  if (order < 2) return terms;
  for (int i = 0; i < count; ++i)
    for (int j = i; j < count; ++j) {
      const Column& a = columns_[static_cast<std::size_t>(i)];
      const Column& b = columns_[static_cast<std::size_t>(j)];
      const bool are_indicators = a.choice >= 0 && a.variable == b.variable;
      if (!a.is_redundant && !b.is_redundant && !are_indicators) terms.emplace_back(i, j);
    }
  return terms;
}

}  // namespace lamina
