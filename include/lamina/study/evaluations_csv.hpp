// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/design_space.hpp"
#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// Evaluations as CSV text: a column for each variable and each response, and the column `error`, which is
/// empty for points that could be measured. Numbers have all their digits; responses that are not finite
/// are empty.
std::string evaluationsCsv(const DesignSpace& space, const std::vector<std::string>& response_names,
                           const std::vector<Evaluation>& evaluations);

}  // namespace lamina
