// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/optimisation/experiment_design.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/fractional_factorial.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostPoints = 1'000'000;

std::vector<double> levelsOf(const Variable& variable, int count) {
  if (variable.kind == VariableKind::Levels) return variable.levels;
  const double low = lowOf(variable);
  const double high = highOf(variable);
  if (variable.kind == VariableKind::Categorical) count = static_cast<int>(high) + 1;
  if (count < 2)
    throw InvalidConfig("variable " + variable.name + ": " + std::to_string(count) +
                        " levels; expected at least 2");
  const bool is_whole = variable.kind != VariableKind::Continuous;
  if (is_whole) count = static_cast<int>(std::min<double>(count, high - low + 1.0));
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) {
    const double level = low + (high - low) * i / (count - 1);
    levels.push_back(is_whole ? std::floor(level + 0.5) : level);
  }
  return levels;
}

/// "2" for all variables, or "2,4,2" for each of them.
std::vector<int> levelCounts(const DesignSpace& space, const std::string& text) {
  const auto refuse = [&] {
    return InvalidConfig("surrogate.levels '" + text + "'; expected one whole number from 2, or " +
                         std::to_string(space.size()) + " with commas between them");
  };
  std::vector<int> counts;
  std::istringstream cells(text);
  for (std::string cell; std::getline(cells, cell, ',');) {
    std::istringstream number(cell);
    int count = 0;
    if (!(number >> count) || !(number >> std::ws).eof() || count < 2) throw refuse();
    counts.push_back(count);
  }
  if (counts.size() == 1) counts.resize(space.size(), counts.front());
  if (counts.size() != space.size()) throw refuse();
  return counts;
}

}  // namespace

void describe(SettingsSchema& schema, ExperimentDesignSettings& settings) {
  schema.choice("surrogate.design", settings.kind,
                {{"full_factorial", DesignKind::FullFactorial},
                 {"fractional_factorial", DesignKind::FractionalFactorial},
                 {"latin_hypercube", DesignKind::LatinHypercube}},
                "How the points tried first are laid out.");
  schema.text("surrogate.levels", settings.levels,
              "Full factorial: levels of continuous and integer variables; one number, or one for each.");
  schema.text("surrogate.generators", settings.generators,
              "Fractional factorial: which variables follow from which (\"d=abc, e=-bcd\").");
  schema.integer("surrogate.samples", settings.samples, {0, 100000},
                 "Latin hypercube: number of points; 0 for ten a variable.");
}

std::vector<DesignPoint> designExperiment(const DesignSpace& space, const ExperimentDesignSettings& settings,
                                          std::uint64_t seed) {
  validate(space);
  switch (settings.kind) {
    case DesignKind::FullFactorial:
      return fullFactorial(space, levelCounts(space, settings.levels));
    case DesignKind::FractionalFactorial:
      return fractionalFactorial(space, settings.generators).points;
    case DesignKind::LatinHypercube:
      break;
  }
  const std::size_t count =
      settings.samples > 0 ? static_cast<std::size_t>(settings.samples) : 10 * space.size();
  return latinHypercube(space, count, seed);
}

std::vector<DesignPoint> fullFactorial(const DesignSpace& space, const std::vector<int>& level_counts) {
  std::vector<DesignPoint> points = {{}};
  for (std::size_t i = 0; i < space.size(); ++i) {
    const std::vector<double> levels = levelsOf(space[i], level_counts.at(i));
    if (points.size() * levels.size() > kMostPoints)
      throw InvalidConfig("full factorial design: more than " + std::to_string(kMostPoints) +
                          " points; expected fewer levels or variables");
    std::vector<DesignPoint> longer;
    for (const DesignPoint& point : points)
      for (const double level : levels) {
        longer.push_back(point);
        longer.back().push_back(level);
      }
    points = std::move(longer);
  }
  return points;
}

}  // namespace lamina
