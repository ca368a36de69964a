// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "gcode_rewrite/gcode_block.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What a line holds anew; what is nothing stays as it is.
struct NewWords {
  const Point3* coordinates = nullptr;
  std::optional<double> extrusion;  ///< in place of E
  std::optional<double> feed;       ///< in place of F, or added
};

/// Appends the line with its X, Y and Z, which come together where the first of them stood, and keeps every
/// other byte.
/// @param command  must hold one of X, Y, Z at least, if there are new coordinates
void appendRewritten(std::string& out, const GcodeBlock& command, const NewWords& words, int decimals);

/// Appends the line without X, Y and Z; as a comment if nothing is left but the command.
void appendWithoutCoordinates(std::string& out, const GcodeBlock& command);

/// Appends "X.. Y.. Z..".
void appendCoordinates(std::string& out, const Point3& point, int decimals);

/// Decimals of E and of F where they are computed.
constexpr int kExtrusionDecimals = 5;
constexpr int kFeedDecimals = 2;

}  // namespace lamina
