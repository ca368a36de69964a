// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether a file has the suffix of SVG files.
bool isSvgName(const std::string& name);

/// Reads the area that an SVG file [SVG2011] fills: the union of its paths, rectangles, circles, ellipses,
/// polygons and polylines, transformed, with curves within 0.005 mm. Coordinates are those of the page, from
/// its lower left corner, y up [mm]; a pixel is 1/96 inch. Of fill colours only `none` has a meaning; lines
/// and strokes have no area.
///
/// @param name  name of the file, for errors
/// @throws InvalidMesh naming file and line, if it is not XML, the size of the page is missing, another
///   element draws (text, image, use), a number is invalid, or nothing is filled
Regions readSvg(std::string_view text, const std::string& name);

}  // namespace lamina
