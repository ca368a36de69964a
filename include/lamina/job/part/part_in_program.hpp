// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How the position of a part in a program was determined.
enum class PartFinding {
  Given,     ///< it was passed in
  Contours,  ///< from the part's contours in the program's layers (`placeContours`)
  Box,       ///< from the bounding boxes of part and deposit, where layers are not level
};

/// "given", "contours", "box".
const char* toString(PartFinding finding);

/// Position of a part in a program.
struct PartInProgram {
  Point3 program_from_part = Point3::Zero();  ///< translation [mm]; programs do not rotate the part
  PartFinding finding = PartFinding::Given;
};

/// The part with which programs are compared.
struct ComparedPart {
  std::string name;  ///< path of a mesh file, or the name of a parametric part
  Mesh mesh;         ///< repaired
};

/// Reads and repairs a part.
/// @throws InvalidMesh, FileError
ComparedPart readComparedPart(const std::string& part, const InputSettings& settings);

/// The part as large as it is printed, for it shrinks (`compensation.shrink_*`).
ComparedPart asPrinted(const ComparedPart& part, const JobSettings& settings);

/// Finds the position of a part in a program, ignoring skirt, brim and start lines. If layers are level, x
/// and y follow from the contours; otherwise from the middle of the bounding box of the part's beads. In z
/// the bottom of the part is put at the bottom of the deposit; if layers are not level, at z = 0, provided
/// that both heights differ by less than half of the thinnest bead.
/// @param given  program_from_part [mm], which is returned; empty to find it
/// @throws InvalidInput if nothing is deposited for the part, or `given` is not finite; if layers are not
///   level and the box deposited is larger than the part's by more than three of its widest beads in any
///   direction; as `placeContours`
/// @throws Cancelled
PartInProgram findPart(const Toolpath& program, const ComparedPart& part, const std::optional<Point3>& given,
                       const JobSettings& settings, Progress& progress);

}  // namespace lamina
