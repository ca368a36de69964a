// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// Parses a line of Klipper: "!! " begins an error of a command, "// " any other message.
PacedReply readKlipperReply(std::string_view line);

/// The command that makes Klipper send a number.
std::string klipperQuestion(std::uint64_t number);

/// What Klipper would misread in a command; empty if nothing.
std::string klipperDefectOf(std::string_view command, int max_line_bytes);

/// Whether a command has the form of Klipper's extended commands and macros: a name instead of a letter and a
/// number.
bool isExtendedCommand(std::string_view command);

}  // namespace lamina
