// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test_problems.hpp"

#include <cstdio>

#include "lamina/base/error.hpp"

namespace lamina {

Variable continuous(const std::string& name, double low, double high) {
  return {name, VariableKind::Continuous, low, high, {}, {}};
}

DesignSpace mixedSpace() {
  return {continuous("pitch_mm", 0.3, 2.5),
          {"walls", VariableKind::Integer, 1.0, 4.0, {}, {}},
          {"layer_mm", VariableKind::Levels, 0.0, 0.0, {0.15, 0.2, 0.3}, {}},
          {"link", VariableKind::Categorical, 0.0, 0.0, {}, {"tangential", "average"}}};
}

DesignSpace unitSpace(std::size_t count) {
  DesignSpace space;
  for (std::size_t i = 0; i < count; ++i)
    space.push_back(continuous(std::string(1, static_cast<char>('a' + i)), -1.0, 1.0));
  return space;
}

CountingEvaluator::CountingEvaluator(double greatest_pitch)
    : greatest_pitch_(greatest_pitch),
      inner_({"time_s", "error_mm3"},
             [this](const DesignPoint& point, Progress&) { return measure(point); }) {}

std::vector<double> CountingEvaluator::measure(const DesignPoint& point) const {
  if (point[0] > greatest_pitch_) throw InvalidInput("pitch 2 is too great: \"\xC3\xA9\"\n");
  const double time_s = (10.0 + point[1]) / (point[0] * point[2]) + point[3];
  const double error_mm3 = (1.0 + point[0]) * (1.0 + point[2]) / point[1] + 0.1 * (1.0 - point[3]);
  return {time_s, error_mm3};
}

std::vector<Evaluation> CountingEvaluator::evaluate(const std::vector<DesignPoint>& points,
                                                    const EvaluationListener& done, Progress& progress) {
  tried_ += static_cast<int>(points.size());
  return inner_.evaluate(points, done, progress);
}

Goals timeAndError() { return {{{"time_s", Sense::Minimise, 1.0}, {"error_mm3", Sense::Minimise, 1.0}}, {}}; }

std::string textOf(const std::vector<Evaluation>& evaluations) {
  std::string text;
  const auto add = [&](const std::vector<double>& numbers) {
    char digits[40];
    for (const double number : numbers) {
      std::snprintf(digits, sizeof digits, "%a ", number);
      text += digits;
    }
  };
  for (const Evaluation& evaluation : evaluations) {
    add(evaluation.point);
    text += "| ";
    add(evaluation.responses);
    text += evaluation.error + "\n";
  }
  return text;
}

}  // namespace lamina
