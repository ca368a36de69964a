// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/optimisation/evaluation.hpp"

namespace lamina {

/// The evaluation of a point that was measured. It counts as failed if there are not as many responses as
/// names.
Evaluation measuredPoint(DesignPoint point, std::vector<double> responses,
                         const std::vector<std::string>& names);

}  // namespace lamina
