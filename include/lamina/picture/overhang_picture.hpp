// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/overhang/overhang.hpp"

namespace lamina {

/// Draws a toolpath from the front right and 30 deg above in pale grey, as a PNG, and over it all unsupported
/// stretches, also those behind the part: overhangs red, bridges yellow, and a dot where a run begins in the
/// air. Many short stretches, as those of sparse infill, appear as a haze.
/// @throws InvalidInput if nothing is deposited; FileError
void drawOverhangs(const Toolpath& toolpath, const OverhangReport& report, const std::string& png_path);

}  // namespace lamina
