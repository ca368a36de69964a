// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Marlin's checksum of a line: the exclusive or of all bytes before the '*'.
std::uint8_t marlinChecksum(std::string_view text);

/// The line as it is sent: "N<number> <command>*<checksum>\n".
std::string frameLine(std::uint64_t number, std::string_view command);

/// Parses a line of the firmware: an unknown one is Information, and a Resend whose number cannot be read has
/// no `line`. A greeting, of whatever firmware, is found anywhere in the line, since stray bytes may precede
/// it after a reset.
FirmwareReply parseReply(std::string_view line);

}  // namespace lamina
