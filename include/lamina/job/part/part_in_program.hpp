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

/// How it was found where a program has put its part.
enum class PartFinding {
  Given,     ///< somebody said so
  Contours,  ///< by the part's contours in the program's layers (`placeContours`)
  Box,       ///< by the boxes of part and deposit: layers that are not level
};

/// "given", "contours", "box".
const char* toString(PartFinding finding);

/// Where a program has put its part.
struct PartInProgram {
  Point3 program_from_part = Point3::Zero();  ///< translation [mm]; programs are not turned
  PartFinding finding = PartFinding::Given;
};

/// The part that programs are compared with.
struct ComparedPart {
  std::string name;  ///< path of a mesh file, or the name of a parametric part
  Mesh mesh;         ///< repaired
};

/// @throws InvalidMesh, FileError
ComparedPart readComparedPart(const std::string& part, const InputSettings& settings);

/// Finds where a program has put a part, whatever its skirt, brim or start lines: in x and y by the contours
/// of level layers, and with its bottom on that of the first layer. Where layers are not level, by the middle
/// of the box of what is deposited for the part, and its bottom.
/// @param given  program_from_part [mm]; found if there is none
/// @throws InvalidInput if nothing is deposited for the part, or the given place is not finite; Cancelled
PartInProgram findPart(const Toolpath& program, const ComparedPart& part, const std::optional<Point3>& given,
                       const JobSettings& settings, Progress& progress);

}  // namespace lamina
