// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// The line at which a job can be resumed after the machine has lost its position. A person has to confirm it
/// at the part, since acknowledged lines need not have been deposited.
struct ResumePoint {
  std::uint64_t line = 1;             ///< the first that was not certainly taken, from 1
  std::optional<std::int32_t> layer;  ///< of that line, as numbered in comments
  std::uint64_t layer_line = 1;       ///< the first of that layer
  double height_mm = 0.0;             ///< z at the start of the line, in the program's coordinates
};

/// Finds that line.
/// @param taken_through  the last line that was certainly taken; 0 for none
/// @throws InvalidInput if no line is left
/// @throws InvalidProgram as `GcodeReader`
ResumePoint resumePointAfter(const StreamableProgram& program, std::uint64_t taken_through);

/// Advice in words: what to look for at the part, and the options of `lamina resume` for that line.
std::string adviceFor(const ResumePoint& point);

}  // namespace lamina
