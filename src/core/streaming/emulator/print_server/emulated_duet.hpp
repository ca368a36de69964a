// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "streaming/emulator/print_server/emulated_printer.hpp"

namespace lamina {

/// The object model of a Duet with a bed, one tool and three axes.
/// @param knows_how_prints_end  as only a Duet with a computer does
nlohmann::json objectModelOf(const EmulatedPrinter& printer, bool knows_how_prints_end);

/// Runs codes as a Duet does, one a line.
/// @return what it says; begins with "Error:" if it refuses one
std::string runCodes(EmulatedPrinter& printer, const std::string& codes);

/// "0:/gcodes/a/b.g" as "a/b.g".
std::string fileOnCard(const std::string& path);

}  // namespace lamina
