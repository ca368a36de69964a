// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/goals.hpp"
#include "lamina/optimisation/surrogate.hpp"

namespace lamina {

/// Several objectives as one number: the sum of weight times response over the mean of the response in the
/// design of experiments [Vega2023, eq. 7 and 14]. Its sense is that of the first objective with a
/// weight; objectives of the other sense are subtracted.
class Fitness {
 public:
  /// Objectives of weight 0 do not count.
  /// @param design  evaluations that failed and responses that are missing do not enter the means; points
  ///   tried several times enter once, by their mean
  /// @throws InvalidConfig as `validate(Goals)` and if all weights are 0; InvalidInput if a response with a
  ///   weight has no value or the mean 0
  Fitness(const Goals& goals, const std::vector<std::string>& response_names,
          const std::vector<Evaluation>& design);

  Sense sense() const { return sense_; }

  /// In the sense above.
  double valueOf(const std::vector<double>& responses) const;

  /// To be made small whatever the sense: the value, or the value with its sign changed.
  double costOf(const std::vector<double>& responses) const;

  /// Of the cost, if responses are independent.
  Prediction predictedCost(const std::vector<Prediction>& predictions) const;

 private:
  struct Term {
    std::size_t response;
    double factor;  ///< of the response in the cost
  };

  Sense sense_ = Sense::Minimise;
  std::vector<Term> terms_;
};

/// Each point once, in order of first appearance, with the mean of each response over the evaluations of it
/// that have a value. Failed evaluations are left out; so are those without any response.
std::vector<Evaluation> withoutReplicates(const std::vector<Evaluation>& samples);

/// The index of the evaluation of least cost among those that hold all constraints and lack no response that
/// counts; the first of equals.
std::optional<std::size_t> bestFeasible(const std::vector<Evaluation>& samples, const Goals& goals,
                                        const std::vector<std::string>& response_names,
                                        const Fitness& fitness);

/// Responses that have a constraint or a weight, as ascending indices.
std::vector<std::size_t> countedResponses(const Goals& goals, const std::vector<std::string>& response_names);

/// Mean absolute error of predictions in per cent of what was measured [Vega2023, eq. 5], over the
/// responses that have a constraint or a weight. One that was measured as 0 counts 0 if it was predicted so,
/// and otherwise makes the error infinite; one that was not measured does too.
double predictionErrorPercent(const Goals& goals, const std::vector<std::string>& response_names,
                              const std::vector<double>& measured, const std::vector<Prediction>& predicted);

}  // namespace lamina
