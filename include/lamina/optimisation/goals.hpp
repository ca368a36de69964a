// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace lamina {

/// Whether less or more of a response is better.
enum class Sense { Minimise, Maximise };

/// A response to be minimised or maximised.
struct Objective {
  std::string response;
  Sense sense = Sense::Minimise;
  double weight = 1.0;  ///< in a sum of objectives (`Fitness`); one of weight 0 is only predicted
};

/// A response that must lie in an interval, bounds included.
struct Constraint {
  std::string response;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// What a search seeks: objectives, and constraints that it has to meet.
struct Goals {
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
};

/// Checks the goals of a search.
/// @throws InvalidConfig naming the response if there is no objective, a weight is negative or not finite, an
///   interval is empty, or a name is none of the responses
void validate(const Goals& goals, const std::vector<std::string>& response_names);

/// The index of a response.
/// @throws InvalidConfig naming the responses that exist if `response` is none of them
std::size_t responseIndex(const std::vector<std::string>& response_names, const std::string& response);

/// The objectives as costs, which are to be minimised: those to be maximised change their sign.
std::vector<double> costsOf(const Goals& goals, const std::vector<std::string>& response_names,
                            const std::vector<double>& responses);

/// Violation of the constraints: the sum of the distances of responses from their intervals, each divided by
/// the magnitude of the bound (by 1 if that is less). 0 if all constraints are met; infinite if a constrained
/// response is not a number.
double violationOf(const Goals& goals, const std::vector<std::string>& response_names,
                   const std::vector<double>& responses);

}  // namespace lamina
