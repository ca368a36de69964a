// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace lamina {

/// Class of a void by its place between the paths of a layer [Sobreviela2014, chapter 3].
enum class VoidClass : std::uint8_t {
  RasterBorder = 0,  ///< R1: between the lines of a raster and the contour or wall around them
  DenseBorder = 1,   ///< D1: between a dense packing and the contour or wall around it
  Core = 2,          ///< C1: inside the innermost contour
  Meeting = 3,       ///< C2: where contours that follow the outline meet those that follow a hole
  ShapeChange = 4,   ///< C3: between a contour and the next
  Corner = 5,        ///< C4: in a corner of less than 60 degrees
  Between = 6,       ///< between the lines of a fill, away from its border
};

/// All classes, in their order.
constexpr VoidClass kVoidClasses[] = {VoidClass::RasterBorder, VoidClass::DenseBorder, VoidClass::Core,
                                      VoidClass::Meeting,      VoidClass::ShapeChange, VoidClass::Corner,
                                      VoidClass::Between};

/// The name of a class in files: "R1", "D1", "C1" to "C4", "between".
const char* toString(VoidClass kind);

}  // namespace lamina
