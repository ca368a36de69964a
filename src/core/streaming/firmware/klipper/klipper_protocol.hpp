// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// What a line of Klipper means: "!! " is an error of a command, "// " everything else that it has to say.
PacedReply readKlipperReply(std::string_view line);

/// Makes Klipper say a number.
std::string klipperQuestion(std::uint64_t number);

/// What Klipper would misread of a command; empty if nothing.
std::string klipperDefectOf(std::string_view command, int max_line_bytes);

/// Whether a command is of the form of Klipper's own and its macros': a name instead of a letter and a
/// number.
bool isExtendedCommand(std::string_view command);

}  // namespace lamina
