// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Writes a binary STL [mm], completely or not at all. Coordinates are rounded to 32-bit floats, as the
/// format requires; a triangle without area gets the normal 0.
///
/// @throws InvalidMesh if a coordinate does not fit a float, or there are more triangles than the format can
///   count
/// @throws FileError   if the file cannot be written
void writeStl(const std::string& path, const Mesh& mesh);

}  // namespace lamina
