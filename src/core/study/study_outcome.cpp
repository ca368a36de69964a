// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/study_outcome.hpp"
#include "lamina/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

std::size_t failedCount(const std::vector<Evaluation>& evaluations) {
  return static_cast<std::size_t>(
      std::count_if(evaluations.begin(), evaluations.end(),
                    [](const Evaluation& evaluation) { return !isEvaluated(evaluation); }));
}

std::vector<SettingText> valuesOf(const DesignSpace& space, const std::vector<std::string>& response_names,
                                  const Evaluation& evaluation) {
  std::vector<SettingText> values;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const bool is_number = space[i].kind != VariableKind::Categorical;
    const double value = evaluation.point.at(i);
    values.push_back({space[i].name, is_number ? numberText(value) : textOf(space[i], value)});
  }
  for (std::size_t i = 0; i < evaluation.responses.size(); ++i)
    if (std::isfinite(evaluation.responses[i]))
      values.push_back({response_names.at(i), numberText(evaluation.responses[i])});
  return values;
}

}  // namespace lamina
