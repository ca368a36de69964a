// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "program/gcode/slicer_comments.hpp"

namespace lamina {

/// What a comment states about the sections of a program.
enum class SectionMark {
  None,
  PartStart,
  Layer,    ///< a layer begins; with the first layer the part begins
  Type,     ///< the lines that follow belong to the part
  Custom,   ///< code of the user follows: the end code, unless a layer or a type comes after it
  PartEnd,  ///< the part ends, unless a layer or a type comes after it
};

/// Reads the comments of Cura, PrusaSlicer, Simplify3D, Slic3r (verbose) and Lamina.
class SectionMarks {
 public:
  SectionMark read(std::string_view comment);

  /// Whether skirt, brim, raft, support or priming tower is being deposited.
  bool isBuildAid() const;
  /// The comment that states a type of unknown name; empty if there is none.
  const std::string& unknownType() const { return unknown_type_; }
  std::optional<double> layerHeight() const { return layer_height_mm_; }  ///< the first one stated [mm]
  const std::string& slicer() const { return slicer_; }                   ///< empty if not stated

 private:
  void readHead(std::string_view comment);

  SlicerContext context_;
  std::optional<double> layer_height_mm_;
  std::string slicer_;
  std::string unknown_type_;
};

}  // namespace lamina
