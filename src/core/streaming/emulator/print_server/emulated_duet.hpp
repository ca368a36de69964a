// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "streaming/emulator/print_server/emulated_printer.hpp"

namespace lamina {

/// Who answers requests to a Duet.
enum class DuetHost : std::uint8_t {
  Board,    ///< the board itself
  Computer  ///< a computer beside it, which also knows how prints ended and which commands were unknown
};

/// The object model of a Duet with a bed, one tool and three axes.
nlohmann::json objectModelOf(const EmulatedPrinter& printer, DuetHost host);

/// Runs codes, one a line, as a Duet does.
/// @return the Duet's output; begins with "Error:" if it refuses a code
std::string runCodes(EmulatedPrinter& printer, const std::string& codes);

/// Name of a file on the card relative to its folder of programs: "0:/gcodes/a/b.g" as "a/b.g".
std::string fileOnCard(const std::string& path);

}  // namespace lamina
