// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "streaming/firmware/ok_paced/ok_paced_firmware.hpp"

namespace lamina {

/// The cyclic redundancy check of a line, over everything from its 'N' to before its '*': 16 bits, polynomial
/// 0x1021, from 0, not reflected (CRC-16/XMODEM) [RepRapFirmware 3.5, GCodeBuffer/StringParser].
std::uint16_t reprapCrc(std::string_view text);

/// "N<number> <command>*<five digits>\n": five digits make the firmware take them for the check above instead
/// of an exclusive or.
std::string reprapFrame(std::uint64_t number, std::string_view command);

/// What a line of RepRapFirmware means, in its emulation of Marlin (USB, telnet).
PacedReply readReprapReply(std::string_view line);

/// Makes RepRapFirmware say a number and where the last motion it took leads to, twice, since its answers
/// have no check.
std::string reprapQuestion(std::uint64_t number, LinkKind link);

/// What RepRapFirmware would misread of a command; empty if nothing.
std::string reprapDefectOf(std::string_view command, int max_line_bytes);

}  // namespace lamina
