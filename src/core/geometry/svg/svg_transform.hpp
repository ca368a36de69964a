// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The numbers of a text, with blanks or commas between them or where a sign or a second point begins the
/// next; nothing if something is no number.
std::optional<std::vector<double>> svgNumbers(std::string_view text);

/// A `transform` of SVG: matrix, translate, scale, rotate, skewX, skewY, the first one outermost. Nothing if
/// it is none.
std::optional<Eigen::Affine2d> svgTransform(std::string_view text);

/// How many millimetres a length of SVG is: "20mm", "96" (pixels), "1in", "2.5cm", "72pt", "6pc". Nothing if
/// it is none, or a share of something.
std::optional<double> svgLength(std::string_view text);

}  // namespace lamina
