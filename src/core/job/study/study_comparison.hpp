// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/study/study_measurement.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/study/study_outcome.hpp"

namespace lamina {

/// Rows to be deposited beside each other, and what could not be measured.
struct StudyComparison {
  std::vector<ComparedRow> rows;
  std::vector<std::string> notes;
};

/// What was chosen (if anything), each published row and, where it names all variables, what is measured at
/// its point, then the baselines.
/// @param in_full  tries points with the measurement's `frontResponseNames`
/// @throws Cancelled
StudyComparison comparisonOf(const Study& study, const StudyMeasurement& measurement, Evaluator& in_full,
                             const StudyOutcome& outcome, Progress& progress);

}  // namespace lamina
