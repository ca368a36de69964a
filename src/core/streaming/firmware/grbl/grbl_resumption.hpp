// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_protocol.hpp"
#include "streaming/firmware/grbl/expected_position.hpp"

namespace lamina {

/// Where a program goes on at a machine that has lived on.
struct GrblResumption {
  std::uint64_t line = 0;  ///< the last one that was certainly run, as the machine's place shows
  ExpectedPosition expected{""};
  std::string refusal;  ///< why it cannot be told; empty if it can
};

/// The line whose end the machine stands at, of those that may have been the last one taken. grbl counts no
/// lines: it can be told where exactly one place of these is the machine's, and where what comes behind it
/// without a motion may be run a second time.
/// @param modes  the machine's answer to `$G`
/// @param work   where it is idle, in the coordinates of the work [mm]
/// @throws FileError if the program is gone
GrblResumption resumptionOf(const StreamableProgram& program, const UnfinishedLines& unfinished,
                            std::string_view modes, const GrblAxes& work);

}  // namespace lamina
