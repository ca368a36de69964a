// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "gcode_rewrite/gcode_block.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// New values for words of a line; a word without a new value keeps its text.
struct NewWords {
  const Point3* coordinates = nullptr;
  std::optional<double> extrusion;  ///< replaces E
  std::optional<double> feed;       ///< replaces F, or is added
};

/// Appends the line with new X, Y and Z, written together at the position of the first of them; every other
/// byte is kept.
/// @param command  must have at least one of X, Y, Z if there are new coordinates
void appendRewritten(std::string& out, const GcodeBlock& command, const NewWords& words, int decimals);

/// Appends the line without X, Y and Z; if nothing but the command is left, the line becomes a comment.
void appendWithoutCoordinates(std::string& out, const GcodeBlock& command);

/// Appends "X.. Y.. Z..".
void appendCoordinates(std::string& out, const Point3& point, int decimals);

/// Decimals of computed values of E and F.
constexpr int kExtrusionDecimals = 5;
constexpr int kFeedDecimals = 2;

}  // namespace lamina
