// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace lamina {

/// What a dry run makes of a command.
enum class DryVerdict : std::uint8_t {
  Keep,     ///< it moves, waits, tells or configures, and switches nothing of a process on
  Process,  ///< it is of the process, or makes the firmware run it
  Target,   ///< the same, unless its target is 0
  Unknown,
};

/// @param code  number of a G command without its fraction
DryVerdict verdictOnG(int code);
/// @param code  number of an M command
DryVerdict verdictOnM(int code);
/// @param name  first word of a command that is no letter with a number, in any case
DryVerdict verdictOnName(std::string_view name);

/// The command that sets a target without a wait for it, of one that does or does not: M104 of M109.
int withoutWait(int code);

/// Whether it begins a statement of a language in G-code (`if`, `while`), without which the lines within it
/// mean something else.
bool isStatement(std::string_view name);

}  // namespace lamina
