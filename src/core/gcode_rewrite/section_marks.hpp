// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "program/gcode/slicer_comments.hpp"

namespace lamina {

/// What a comment says of the section of a program that holds the part.
enum class SectionMark {
  None,
  PartStart,
  Layer,    ///< a layer begins, and with the first of them the part
  Type,     ///< what follows is of the part
  Custom,   ///< what follows is code of the user: the end code, unless a layer or a type comes after it
  PartEnd,  ///< likewise
};

/// Reads the comments of Cura, PrusaSlicer, Simplify3D, Slic3r (verbose) and Lamina.
class SectionMarks {
 public:
  SectionMark read(std::string_view comment);

  /// Whether what is deposited now is skirt, brim, raft, support or priming tower.
  bool isBuildAid() const;
  /// Of a comment that reports the type of what follows by a name not known; empty if there is none.
  const std::string& unknownType() const { return unknown_type_; }
  std::optional<double> layerHeight() const { return layer_height_mm_; }  ///< reported first [mm]
  const std::string& slicer() const { return slicer_; }                   ///< empty if not reported

 private:
  void readHead(std::string_view comment);

  SlicerContext context_;
  std::optional<double> layer_height_mm_;
  std::string slicer_;
  std::string unknown_type_;
};

}  // namespace lamina
