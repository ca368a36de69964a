// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// Title and subtitle above a picture.
struct PictureTitle {
  std::string title;
  std::string subtitle;
};

/// Draws heights seen from above, as a PNG, with colour bar [mm] and scale bar. Unknown cells are grey. The
/// colour bar leaves out the lowest 0.5 % and the highest 0.5 % of the known heights, which have the colours
/// at its ends.
/// @throws FileError
void drawHeightMap(const std::string& path, const HeightMap& heights, const PictureTitle& title);

/// Draws differences of heights as a PNG: white is none, red too high, blue too low. The colour bar ends at
/// the same magnitude on both sides, and leaves out extremes as `drawHeightMap` does.
/// @throws FileError
void drawDeviation(const std::string& path, const HeightMap& deviation, const PictureTitle& title);

}  // namespace lamina
