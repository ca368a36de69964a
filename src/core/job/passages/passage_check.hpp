// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/output_writer.hpp"

namespace lamina {

/// Checks the passages of an arm's program as it would be written: to and from the part, and between its
/// files. Nothing is checked if `clearance.need` is `never`.
/// @return time of the passages [s]; 0 for a program that is not read back, as with a tool other than the
///   arm's
/// @throws Unreachable if a passage is not free, with what to try
double clearPassageTime(const std::string& output, const PlacedToolpath& placed,
                        const ProgramSettings& program, const JobSettings& settings);

}  // namespace lamina
