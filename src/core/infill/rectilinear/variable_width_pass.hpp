// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/rectilinear/variable_width_slices.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// The bead that fills the variable-width line round the line that begins at `left`: in the middle of what
/// the variable-width line holds, and as wide. From left to right, in the raster frame; a single point if
/// there is no more room.
FillPath passThrough(const VariableWidthLines& strips, std::uint32_t left, const PassEndShape& left_end,
                     const PassEndShape& right_end);

}  // namespace lamina
