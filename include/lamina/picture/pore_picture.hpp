// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/pores/pore_projection.hpp"

namespace lamina {

/// Draws a projection of pores as a PNG: solid grey, each inner opening in a colour of its own, openings at
/// the border pale.
/// @throws FileError if it cannot be written
void drawProjection(const PoreProjection& projection, const std::string& png_path);

}  // namespace lamina
