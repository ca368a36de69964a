// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/output_writer.hpp"

namespace lamina {

/// Checks the ways to and from the part, and between the files, of an arm's program as it would be written to
/// a file; nothing if `clearance.need` is `never`.
/// @throws Unreachable if a way is not free, with what to try
void requireClearPassages(const std::string& output, const PlacedToolpath& placed,
                          const ProgramSettings& program, const JobSettings& settings);

}  // namespace lamina
