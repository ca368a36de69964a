// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// The cyclic redundancy check of a line from its 'N' up to its '*', excluded: 16 bits, polynomial 0x1021,
/// initial value 0, not reflected (CRC-16/XMODEM) [RepRapFirmware 3.5, GCodeBuffer/StringParser].
std::uint16_t reprapCrc(std::string_view text);

/// A line in the form "N<number> <command>*<five digits>\n". Five digits tell the firmware that the check is
/// the CRC above and not an exclusive or.
std::string reprapFrame(std::uint64_t number, std::string_view command);

/// Parses a line of RepRapFirmware in its emulation of Marlin (USB, telnet).
PacedReply readReprapReply(std::string_view line);

/// The command that makes RepRapFirmware send a number and the end of the last motion accepted. Both are sent
/// twice, as its answers have no checksum.
std::string reprapQuestion(std::uint64_t number, LinkKind link);

/// What RepRapFirmware would misread in a command; empty if nothing.
std::string reprapDefectOf(std::string_view command, int max_line_bytes);

}  // namespace lamina
