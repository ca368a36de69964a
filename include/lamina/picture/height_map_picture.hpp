// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// What stands above a picture.
struct PictureTitle {
  std::string title;
  std::string subtitle;
};

/// Draws heights seen from above, as a PNG: coloured from the lowest to the highest known one, unknown cells
/// grey, with colour bar [mm] and scale bar. Where hardly anything (0.5 %) lies beyond, the ends of the
/// colour bar leave it out.
/// @throws FileError
void drawHeightMap(const std::string& path, const HeightMap& heights, const PictureTitle& title);

/// Draws differences of heights as a PNG: white is none, red too high, blue too low; the colours end at the
/// same magnitude on both sides.
/// @throws FileError
void drawDeviation(const std::string& path, const HeightMap& deviation, const PictureTitle& title);

}  // namespace lamina
