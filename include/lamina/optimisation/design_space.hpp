// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/random.hpp"

namespace lamina {

/// The values that a variable may take.
enum class VariableKind {
  Continuous,   ///< any number between two bounds, both included
  Integer,      ///< whole numbers between two bounds, both included
  Levels,       ///< one of several numbers; values in between are meaningful, but cannot be chosen
  Categorical,  ///< one of several texts, without order
};

/// A setting or argument that a search may change.
struct Variable {
  std::string name;  ///< a key of the configuration, or a name in the arguments of a command
  VariableKind kind = VariableKind::Continuous;
  double low = 0.0;                  ///< Continuous, Integer
  double high = 0.0;                 ///< Continuous, Integer
  std::vector<double> levels;        ///< Levels: ascending, at least two
  std::vector<std::string> choices;  ///< Categorical: at least two, all different
};

/// One value for each variable, in order. Categorical: the index of the choice.
using DesignPoint = std::vector<double>;

/// The variables of a search.
using DesignSpace = std::vector<Variable>;

/// Least value of a variable.
double lowOf(const Variable& variable);
/// Greatest value of a variable; Categorical: the last index.
double highOf(const Variable& variable);

/// Checks the variables of a search.
/// @throws InvalidConfig if there is no variable; naming the variable if it has no name or the name of
///   another one, if bounds are not finite or not in order, if integer bounds are not whole, if there are
///   fewer than two levels or choices, if levels are not finite or do not ascend, or if a choice stands twice
void validate(const DesignSpace& space);

/// Checks that a point lies in the space.
/// @throws InvalidInput if the point does not have one value for each variable; naming variable and value if
///   the variable cannot take that value
void requireWithin(const DesignSpace& space, const DesignPoint& point);

/// The nearest point whose values are all allowed: clamped to the bounds, rounded to whole numbers, indices
/// or levels (halves up).
DesignPoint nearestWithin(const DesignSpace& space, DesignPoint point);

/// A random point, with each value uniform over those of its variable and independent of the others.
DesignPoint randomPoint(const DesignSpace& space, Random& random);

/// A value as it stands in a configuration: a choice, or the shortest number that reads back the same.
std::string textOf(const Variable& variable, double value);

/// The value that a text stands for.
/// @throws InvalidInput naming variable and text if the text is none of the variable's values
double valueOf(const Variable& variable, const std::string& text);

}  // namespace lamina
