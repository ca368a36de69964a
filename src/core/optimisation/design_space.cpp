// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/design_space.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <set>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

void requireBounds(const Variable& variable) {
  const std::string bounds = exactText(variable.low) + " to " + exactText(variable.high);
  if (!std::isfinite(variable.low) || !std::isfinite(variable.high) || variable.low >= variable.high)
    throw InvalidConfig("variable " + variable.name + ": bounds " + bounds +
                        "; expected two finite numbers, the lower one first");
  if (variable.kind == VariableKind::Integer &&
      (variable.low != std::floor(variable.low) || variable.high != std::floor(variable.high)))
    throw InvalidConfig("variable " + variable.name + ": bounds " + bounds + "; expected whole numbers");
}

void requireLevels(const Variable& variable) {
  const auto& levels = variable.levels;
  if (levels.size() < 2)
    throw InvalidConfig("variable " + variable.name + ": " + std::to_string(levels.size()) +
                        " levels; expected at least 2");
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (!std::isfinite(levels[i]) || (i > 0 && levels[i] <= levels[i - 1]))
      throw InvalidConfig("variable " + variable.name + ": level " + exactText(levels[i]) +
                          "; expected finite numbers in ascending order");
}

void requireChoices(const Variable& variable) {
  const auto& choices = variable.choices;
  if (choices.size() < 2)
    throw InvalidConfig("variable " + variable.name + ": " + std::to_string(choices.size()) +
                        " choices; expected at least 2");
  if (std::set<std::string>(choices.begin(), choices.end()).size() != choices.size())
    throw InvalidConfig("variable " + variable.name + ": a choice stands twice in " + listed(choices));
}

void requireUsable(const Variable& variable) {
  if (variable.name.empty()) throw InvalidConfig("variable without a name");
  switch (variable.kind) {
    case VariableKind::Continuous:
    case VariableKind::Integer:
      requireBounds(variable);
      break;
    case VariableKind::Levels:
      requireLevels(variable);
      break;
    case VariableKind::Categorical:
      requireChoices(variable);
      break;
  }
}

double nearestLevel(const std::vector<double>& levels, double value) {
  double nearest = levels.front();
  for (const double level : levels)
    if (std::abs(level - value) <= std::abs(nearest - value)) nearest = level;
  return nearest;
}

double nearestAllowed(const Variable& variable, double value) {
  if (variable.kind == VariableKind::Levels) return nearestLevel(variable.levels, value);
  const double clamped = std::clamp(value, lowOf(variable), highOf(variable));
  return variable.kind == VariableKind::Continuous ? clamped : std::floor(clamped + 0.5);
}

/// What a variable takes, as a person reads it.
std::string allowedBy(const Variable& variable) {
  if (variable.kind == VariableKind::Categorical) return "one of " + listed(variable.choices);
  if (variable.kind == VariableKind::Levels) {
    std::vector<std::string> levels;
    for (const double level : variable.levels) levels.push_back(exactText(level));
    return "one of " + listed(levels);
  }
  return (variable.kind == VariableKind::Integer ? "a whole number from " : "a number from ") +
         exactText(variable.low) + " to " + exactText(variable.high);
}

}  // namespace

double lowOf(const Variable& variable) {
  if (variable.kind == VariableKind::Categorical) return 0.0;
  return variable.kind == VariableKind::Levels ? variable.levels.front() : variable.low;
}

double highOf(const Variable& variable) {
  if (variable.kind == VariableKind::Categorical) return static_cast<double>(variable.choices.size() - 1);
  return variable.kind == VariableKind::Levels ? variable.levels.back() : variable.high;
}

void validate(const DesignSpace& space) {
  if (space.empty()) throw InvalidConfig("no variable to search; expected at least one");
  std::set<std::string> names;
  for (const Variable& variable : space) {
    requireUsable(variable);
    if (!names.insert(variable.name).second)
      throw InvalidConfig("variable " + variable.name + " stands twice");
  }
}

void requireWithin(const DesignSpace& space, const DesignPoint& point) {
  if (point.size() != space.size())
    throw InvalidInput(std::to_string(point.size()) + " values for " + std::to_string(space.size()) +
                       " variables");
  for (std::size_t i = 0; i < space.size(); ++i)
    if (!std::isfinite(point[i]) || nearestAllowed(space[i], point[i]) != point[i])
      throw InvalidInput("variable " + space[i].name + ": " + exactText(point[i]) + "; expected " +
                         allowedBy(space[i]));
}

DesignPoint nearestWithin(const DesignSpace& space, DesignPoint point) {
  for (std::size_t i = 0; i < space.size(); ++i) point[i] = nearestAllowed(space[i], point[i]);
  return point;
}

DesignPoint randomPoint(const DesignSpace& space, Random& random) {
  DesignPoint point;
  for (const Variable& variable : space) {
    if (variable.kind == VariableKind::Continuous) {
      point.push_back(random.uniform(variable.low, variable.high));
    } else if (variable.kind == VariableKind::Levels) {
      point.push_back(variable.levels[random.below(variable.levels.size())]);
    } else {
      const auto count = static_cast<std::uint64_t>(highOf(variable) - lowOf(variable)) + 1;
      point.push_back(lowOf(variable) + static_cast<double>(random.below(count)));
    }
  }
  return point;
}

std::string textOf(const Variable& variable, double value) {
  if (variable.kind != VariableKind::Categorical) return exactText(value);
  return variable.choices.at(static_cast<std::size_t>(value));
}

double valueOf(const Variable& variable, const std::string& text) {
  const auto refuse = [&] {
    return InvalidInput("variable " + variable.name + ": '" + text + "'; expected " + allowedBy(variable));
  };
  if (variable.kind == VariableKind::Categorical) {
    const auto found = std::find(variable.choices.begin(), variable.choices.end(), text);
    if (found == variable.choices.end()) throw refuse();
    return static_cast<double>(found - variable.choices.begin());
  }
  const std::string_view digits = trimmed(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) throw refuse();
  if (!std::isfinite(value) || nearestAllowed(variable, value) != value) throw refuse();
  return value;
}

}  // namespace lamina
