// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// Where a program that was cut off ends.
struct EarlyEnd {
  std::size_t line = 0;  ///< number of the last line that is not empty, from 1
  std::string reason;    ///< for people: what is missing, and the last layer as the program counts
};

/// Finds G-code programs that lack the mark that their writer puts at the end: Lamina ("; end of the part"),
/// PrusaSlicer and Slic3r ("; filament used"), Simplify3D ("; layer end"). Cura states the number of layers
/// at the start, and the time taken at the end of each layer. Nothing is known of programs of other writers,
/// or without comments.
/// @return nothing if the program is whole, or nothing is known of its end
std::optional<EarlyEnd> earlyEnd(std::string_view program);

}  // namespace lamina
