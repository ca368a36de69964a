// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// The line at which a job can be resumed after the machine has lost its position. A person has to confirm it
/// by a look at the part, since acknowledged lines need not have been deposited. Lines carry commands and
/// count from 1.
struct ResumePoint {
  std::uint64_t line = 1;  ///< first line that the machine has not certainly accepted
  /// Layer of that line by the program's comments; nothing before the first layer.
  std::optional<std::int32_t> layer;
  std::uint64_t layer_line = 1;  ///< first line of that layer
  double height_mm = 0.0;        ///< z at the start of `line`, in the program's coordinates
};

/// Finds the line at which a job can be resumed.
/// @param taken_through  last line that the machine has certainly accepted; 0 for none
/// @throws InvalidInput if no line is left
/// @throws InvalidProgram as `GcodeReader`
ResumePoint resumePointAfter(const StreamableProgram& program, std::uint64_t taken_through);

/// Advice in words: what to check on the part, and the options of `lamina resume` for the line.
std::string adviceFor(const ResumePoint& point);

}  // namespace lamina
