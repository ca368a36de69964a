// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/optimisation/decision.hpp"
#include "lamina/optimisation/goals.hpp"

namespace lamina {

/// What a response counts in a decision.
struct Criterion {
  std::string response;
  double weight = 1.0;  ///< 0: not looked at
  Sense sense = Sense::Minimise;
};

/// The criteria of a decision: under-fill and volume error weigh 3 and all other responses 1
/// ([Guacheta2021, section 4.4] leaves the weights open), but for those that are
/// given.
/// @param weights    by response, numbers
/// @param maximised  responses of which more is better
/// @throws InvalidConfig naming the response if a name is none of them, or a weight is no number from 0
std::vector<Criterion> criteriaOf(const std::vector<std::string>& response_names,
                                  const std::vector<SettingText>& weights,
                                  const std::vector<std::string>& maximised);

/// Chooses among alternatives by their responses: `decide` on those that weigh something, where those to be
/// maximised have their sign changed.
/// @param responses  by alternative, in the order of the criteria
/// @throws InvalidInput naming alternative and response if one that weighs something is not finite; as
/// `decide`
Decision decide(const std::vector<Criterion>& criteria, const std::vector<std::vector<double>>& responses,
                DecisionMethod method);

/// "linmap" or "topsis".
/// @throws InvalidConfig if it is neither
DecisionMethod decisionMethodOf(const std::string& name);

}  // namespace lamina
