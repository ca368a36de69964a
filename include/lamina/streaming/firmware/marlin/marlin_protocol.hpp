// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lamina/streaming/job/firmware_reply.hpp"

namespace lamina {

/// Exclusive or of all bytes: Marlin's check of a line, over everything before the '*'.
std::uint8_t marlinChecksum(std::string_view text);

/// "N<number> <command>*<checksum>\n".
std::string frameLine(std::uint64_t number, std::string_view command);

/// What a line from the firmware means. Nothing is refused: an unknown line is Information, a resend whose
/// number cannot be read has no line. A greeting counts wherever it stands in the line, since a reset puts
/// stray bytes on the link, and whichever firmware sends it.
FirmwareReply parseReply(std::string_view line);

}  // namespace lamina
