// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/optimisation/evaluation.hpp"
#include "lamina/study/study.hpp"

namespace lamina {

/// A measurement that runs the commands of a study for each point, in a new scratch folder. A program called
/// `lamina` is the one in the folder of the running program.
///
/// The measurement throws InvalidInput if a command ends with an exit code other than 0 (with the end of its
/// error output), prints no JSON, or has no number at a pointer; TimedOut, FileError, Cancelled as
/// `runProgram`.
/// @param study  must have commands; it is copied
PointMeasurement commandMeasurement(const Study& study);

}  // namespace lamina
