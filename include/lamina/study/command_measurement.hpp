// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/optimisation/evaluation.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// Measures points by the commands of a study, in a scratch folder of its own for each point. A program
/// called `lamina` is the one beside the program that runs.
///
/// The measurement throws InvalidInput if a command ends with another exit code than 0 (with the end of what
/// it wrote on standard error), prints no JSON, or has no number at a pointer; TimedOut, FileError, Cancelled
/// as `runProgram`.
/// @param study  with commands; kept
PointMeasurement commandMeasurement(const Study& study);

}  // namespace lamina
