// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Whether the name is that of an SVG file.
bool isSvgName(const std::string& name);

/// The area that an SVG file [SVG2011] fills: its paths, rectangles, circles, ellipses, polygons and
/// polylines with their transforms, one united with the other, curves within 0.005 mm. x and y as on the
/// page, from its lower left corner, y up [mm]; a pixel is 1/96 inch. Colours do not count but for `none`;
/// lines and strokes have no area.
///
/// @param name  of the file, for errors
/// @throws InvalidMesh naming file and line: no XML, no size of the page, an element that is none of these
/// and
///   draws (text, image, use), a number that is none, or nothing that is filled
Regions readSvg(std::string_view text, const std::string& name);

}  // namespace lamina
