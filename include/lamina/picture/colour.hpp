// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// A colour by its shares of red, green and blue light, and its opacity, each 0 to 1.
struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double alpha = 1.0;
};

/// The colour made darker (factor below 1) or lighter (above 1); opacity stays.
Colour shaded(const Colour& colour, double factor);

enum class ColourMap {
  Sequential,  ///< dark blue to yellow, evenly lighter: for heights
  Diverging,   ///< blue over white to red: for differences, 0 in the middle
};

/// Colour of a fraction, which is clamped to [0, 1]; light grey if it is not a number.
Colour colourAt(ColourMap map, double fraction);

}  // namespace lamina
