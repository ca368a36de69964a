// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/optimisation/search_problem.hpp"

namespace lamina {

Variable continuous(const std::string& name, double low, double high);

/// One variable of each kind: pitch_mm 0.3 to 2.5, walls 1 to 4, layer_mm 0.15, 0.2 or 0.3, link tangential
/// or average.
DesignSpace mixedSpace();

/// So many continuous variables from -1 to 1, named a, b, c ...
DesignSpace unitSpace(std::size_t count);

/// Two responses of a point of the mixed space against each other: "time_s" and "error_mm3". Counts what it
/// is asked for.
class CountingEvaluator final : public Evaluator {
 public:
  /// @param greatest_pitch  points above it fail
  explicit CountingEvaluator(double greatest_pitch = 9.0);

  int tried() const { return tried_; }

  const std::vector<std::string>& responseNames() const override { return inner_.responseNames(); }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override;

 private:
  std::vector<double> measure(const DesignPoint& point) const;

  double greatest_pitch_;
  int tried_ = 0;
  ParallelEvaluator inner_;
};

/// Minimise both responses of the counting evaluator.
Goals timeAndError();

/// All numbers of evaluations in hexadecimal, so that texts are equal only if all bits are.
std::string textOf(const std::vector<Evaluation>& evaluations);

}  // namespace lamina
