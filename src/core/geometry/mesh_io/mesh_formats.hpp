// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/base/input_file.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

// One reader a format: bytes in, welded triangles in the file's own unit out. `name` is for error messages.
// All throw InvalidMesh.

/// Whether the triangles have no border and enclose something: then none is missing, whatever a header says.
bool isClosedSurface(const Mesh& mesh);

/// What a binary STL has before its triangles [bytes].
constexpr std::size_t kBinaryStlStart = 84;
/// Whether a file that starts with these bytes has exactly the size that the triangle count of a binary STL
/// asks for.
bool isExactBinaryStl(std::string_view start, std::size_t size);
/// Whether the bytes are text with facets, or a solid that ends without any.
bool isAsciiStl(std::string_view bytes);
bool isPly(std::string_view bytes);
/// Whether the bytes are a ZIP archive, as every 3MF file is.
bool isThreemf(std::string_view bytes);
/// Whether the bytes start as STEP files do.
bool isStep(std::string_view bytes);
/// Whether the bytes are text with lines that start with the letter v.
bool isObj(std::string_view bytes);

Mesh readBinaryStl(std::string_view bytes, const std::string& name);
/// The same of an exact one, piece by piece without holding it whole, from behind its start.
Mesh readExactBinaryStl(InputFile& file, std::string_view start, const std::string& name);
Mesh readAsciiStl(std::string_view bytes, const std::string& name);
Mesh readPly(std::string_view bytes, const std::string& name);
Mesh readObj(std::string_view bytes, const std::string& name);
/// In millimetres: the format states its unit.
Mesh readThreemf(std::string_view bytes, const std::string& name);

}  // namespace lamina
