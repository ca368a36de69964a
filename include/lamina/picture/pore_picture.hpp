// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/pores/pore_projection.hpp"

namespace lamina {

/// A PNG picture of where light falls through: solid grey, inner openings each in a colour, those at the
/// border pale.
/// @throws FileError if it cannot be written
void drawProjection(const PoreProjection& projection, const std::string& png_path);

}  // namespace lamina
