// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/geometry/mesh.hpp"

namespace lamina {

// One reader a format: bytes in, welded triangles in the file's own unit out. `name` is for error messages.
// All throw InvalidMesh.

/// Whether the length of the bytes is exactly what the triangle count of a binary STL asks for.
bool isExactBinaryStl(std::string_view bytes);
/// Whether the bytes are text that speaks of facets and vertices.
bool isAsciiStl(std::string_view bytes);

Mesh readBinaryStl(std::string_view bytes, const std::string& name);
Mesh readAsciiStl(std::string_view bytes, const std::string& name);

}  // namespace lamina
