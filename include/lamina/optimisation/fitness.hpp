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
/// design of experiments [Vega2023, eq. 7 and 14]. It is to be minimised or maximised like the first
/// objective that has a weight; objectives of the opposite sense are subtracted.
class Fitness {
 public:
  /// Objectives of weight 0 do not count.
  /// @param design  evaluations over which the means are taken, without those that failed and without missing
  ///   responses; points that were tried several times enter once, by their mean
  /// @throws InvalidConfig as `validate(Goals)` and if all weights are 0; InvalidInput if a response with a
  ///   weight has no value or the mean 0
  Fitness(const Goals& goals, const std::vector<std::string>& response_names,
          const std::vector<Evaluation>& design);

  Sense sense() const { return sense_; }

  /// The fitness of responses, to be minimised or maximised as `sense` says.
  double valueOf(const std::vector<double>& responses) const;

  /// The fitness as a cost, which is always to be minimised: with its sign changed if it is to be maximised.
  double costOf(const std::vector<double>& responses) const;

  /// Prediction of the cost from those of the responses, which are taken as independent.
  Prediction predictedCost(const std::vector<Prediction>& predictions) const;

 private:
  struct Term {
    std::size_t response;
    double factor;  ///< factor on the response in the cost
  };

  Sense sense_ = Sense::Minimise;
  std::vector<Term> terms_;
};

/// Each point once, in order of first appearance, with the mean of each response over the point's evaluations
/// that have a value. Failed evaluations and those without any response are left out.
std::vector<Evaluation> withoutReplicates(const std::vector<Evaluation>& samples);

/// The index of the evaluation of least cost among those that meet all constraints and have all responses
/// that count; the first one if several have that cost. None if there is no such evaluation.
std::optional<std::size_t> bestFeasible(const std::vector<Evaluation>& samples, const Goals& goals,
                                        const std::vector<std::string>& response_names,
                                        const Fitness& fitness);

/// Responses that have a constraint or a weight, as ascending indices.
std::vector<std::size_t> countedResponses(const Goals& goals, const std::vector<std::string>& response_names);

/// Mean absolute error of predictions in per cent of the measured values [Vega2023, eq. 5], over the
/// responses that have a constraint or a weight. A response that was measured as 0 counts 0 if it was
/// predicted as 0, and otherwise makes the error infinite; so does a response that was not measured.
double predictionErrorPercent(const Goals& goals, const std::vector<std::string>& response_names,
                              const std::vector<double>& measured, const std::vector<Prediction>& predicted);

}  // namespace lamina
