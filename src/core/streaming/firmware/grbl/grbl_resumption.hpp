// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_protocol.hpp"
#include "streaming/firmware/grbl/expected_position.hpp"

namespace lamina {

/// The line at which a program is resumed on a machine that was not reset.
struct GrblResumption {
  std::uint64_t line = 0;  ///< number of the last line that was certainly run, by the machine's position
  ExpectedPosition expected{""};
  std::string refusal;  ///< why the line is not certain; empty if it is
};

/// Finds the line at whose end the machine stands, among the lines that may have been accepted last. grbl
/// does not count lines: the line is certain only if exactly one of these lines ends at the machine's
/// position. Later lines that do not move may be run twice.
/// @param modes  the machine's answer to `$G`
/// @param work   position of the idle machine in work coordinates [mm]
/// @throws FileError if the program is gone
GrblResumption resumptionOf(const StreamableProgram& program, const UnfinishedLines& unfinished,
                            std::string_view modes, const GrblAxes& work);

}  // namespace lamina
