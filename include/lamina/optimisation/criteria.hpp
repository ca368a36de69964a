// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/decision.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// The weight of a response in a decision, and whether less or more of the response is better.
struct Criterion {
  std::string response;
  double weight = 1.0;  ///< 0: the response is ignored
  Sense sense = Sense::Minimise;
};

/// The criteria of a decision, one for each response. Unless `weights` states another weight, under-fill and
/// volume error have the weight 3 and all other responses the weight 1 ([Guacheta2021, section 4.4] leaves
/// the weights open).
/// @param weights  names of responses, and their weights as text
/// @param maximised  names of responses of which more is better
/// @throws InvalidConfig naming the entry, if its name is no response, or its weight is no number of 0 or
///   more
std::vector<Criterion> criteriaOf(const std::vector<std::string>& response_names,
                                  const std::vector<SettingText>& weights,
                                  const std::vector<std::string>& maximised);

/// Chooses among alternatives by their responses, as `decide` of `decision.hpp` does by costs. Responses of
/// weight 0 are left out, and those to be maximised enter with their sign changed.
/// @param responses  for each alternative, in the order of the criteria
/// @throws InvalidInput naming alternative and response if a response with a weight other than 0 is not
///   finite; otherwise as `decide` of `decision.hpp`
Decision decide(const std::vector<Criterion>& criteria, const std::vector<std::vector<double>>& responses,
                DecisionMethod method);

/// The method that is named "linmap" or "topsis".
/// @throws InvalidConfig if it is neither
DecisionMethod decisionMethodOf(const std::string& name);

}  // namespace lamina
