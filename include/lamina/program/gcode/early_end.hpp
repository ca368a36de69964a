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
  std::size_t line = 0;  ///< the last one that is not empty, from 1
  std::string reason;    ///< for people: what is missing, and the layer it ends in as the program counts
};

/// Finds programs in G-code that end before what their writer puts at their end: Lamina ("; end of the
/// part"), PrusaSlicer and Slic3r ("; filament used"), Simplify3D ("; layer end"), and Cura, which states at
/// the start how many layers there are and, at the end of each, how long it took. Of programs that nobody
/// of these wrote nothing is known; nor of those that lost their comments.
/// @return nothing if the program is whole, or nothing is known of its end
std::optional<EarlyEnd> earlyEnd(std::string_view program);

}  // namespace lamina
