// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/base/input_file.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

// One reader for each format: it takes bytes and returns welded triangles in the unit of the file. `name` is
// for error messages. All throw InvalidMesh.

/// Whether the triangles have no border and enclose a volume; then no triangle is missing, whatever the
/// header states.
bool isClosedSurface(const Mesh& mesh);

/// Number of bytes of a binary STL before its triangles.
constexpr std::size_t kBinaryStlStart = 84;
/// Whether a file that begins with these bytes has exactly the size that follows from the triangle count of a
/// binary STL.
bool isExactBinaryStl(std::string_view start, std::size_t size);
/// Whether the bytes are an STL in text: with facets, or with a solid that ends without any.
bool isAsciiStl(std::string_view bytes);
bool isPly(std::string_view bytes);
/// Whether the bytes are a ZIP archive, as every 3MF file is.
bool isThreemf(std::string_view bytes);
/// Whether the bytes begin as a STEP file does.
bool isStep(std::string_view bytes);
/// Whether the bytes are text with lines that start with the letter v.
bool isObj(std::string_view bytes);

Mesh readBinaryStl(std::string_view bytes, const std::string& name);
/// Reads a binary STL of exact size piece by piece, without holding all of it in memory, from the end of
/// `start` on.
Mesh readExactBinaryStl(InputFile& file, std::string_view start, const std::string& name);
Mesh readAsciiStl(std::string_view bytes, const std::string& name);
Mesh readPly(std::string_view bytes, const std::string& name);
Mesh readObj(std::string_view bytes, const std::string& name);
/// Reads a 3MF file; the result is in mm, as the format states its unit.
Mesh readThreemf(std::string_view bytes, const std::string& name);

}  // namespace lamina
