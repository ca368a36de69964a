// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {
namespace {

std::string header(const std::string& format, const std::string& vertices = "4") {
  return "ply\nformat " + format + " 1.0\ncomment a tetrahedron\nelement vertex " + vertices +
         "\nproperty float x\nproperty uchar red\nproperty float y\nproperty double z\nproperty list uchar "
         "short tags\n"
         "element edge 1\nproperty int vertex1\n"
         "element face 4\nproperty list uchar int vertex_indices\nproperty uchar flags\nend_header\n";
}

const std::string kAsciiBody =
    "0 255 0 0 0\n1 0 0 0 2 7 8\n0 0 1 0 0\n0 0 0 1 1 3\n5\n3 0 2 1 0\n3 0 1 3 0\n3 0 3 2 0\n3 1 2 3 0\n";

template <class Number>
void append(std::string& bytes, Number number, bool is_swapped) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  if (is_swapped) std::reverse(raw, raw + sizeof number);
  bytes.append(raw, sizeof number);
}

std::string binaryBody(bool is_swapped) {
  std::string bytes;
  const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& corner : corners) {
    append(bytes, static_cast<float>(corner[0]), is_swapped);
    append(bytes, std::uint8_t{200}, is_swapped);
    append(bytes, static_cast<float>(corner[1]), is_swapped);
    append(bytes, corner[2], is_swapped);
    append(bytes, std::uint8_t{1}, is_swapped);
    append(bytes, std::int16_t{-3}, is_swapped);
  }
  append(bytes, std::int32_t{9}, is_swapped);
  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& face : faces) {
    append(bytes, std::uint8_t{3}, is_swapped);
    for (const std::int32_t vertex : face) append(bytes, vertex, is_swapped);
    append(bytes, std::uint8_t{0}, is_swapped);
  }
  return bytes;
}

std::string plyReaderMessageOf(const std::string& bytes) {
  try {
    readMeshFromBytes(bytes, "part.ply");
  } catch (const InvalidMesh& error) {
    return error.what();
  }
  return "accepted";
}

void expectTetrahedron(const std::string& bytes) {
  const Mesh mesh = readMeshFromBytes(bytes, "part");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-15);
}

TEST(PlyReader, ReadsAsciiWithExtraPropertiesAndElements) { expectTetrahedron(header("ascii") + kAsciiBody); }

TEST(PlyReader, ReadsBothByteOrders) {
  expectTetrahedron(header("binary_little_endian") + binaryBody(false));
  expectTetrahedron(header("binary_big_endian") + binaryBody(true));
}

TEST(PlyReader, RefusesEveryShorterPiece) {
  const std::string whole = header("binary_little_endian") + binaryBody(false);
  // The flags of the last face are part of the file.
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(plyReaderMessageOf(whole.substr(0, length)), "accepted") << length;
}

TEST(PlyReader, RefusesACountThatTheFileCannotHold) {
  EXPECT_NE(plyReaderMessageOf(header("binary_little_endian", "18446744073709551615") + binaryBody(false)),
            "accepted");
  EXPECT_NE(plyReaderMessageOf(header("ascii", "4000000000") + kAsciiBody), "accepted");
  EXPECT_NE(plyReaderMessageOf(header("ascii", "99999999999999999999") + kAsciiBody).find("part.ply:4"),
            std::string::npos);
}

TEST(PlyReader, NamesTheLineOfANumberThatIsNotFinite) {
  std::string body = kAsciiBody;
  body.replace(0, 1, "nan");
  EXPECT_EQ(plyReaderMessageOf(header("ascii") + body),
            "part.ply:16: 'nan' where a finite number is expected");
}

TEST(PlyReader, RefusesAnIndexBeyondTheVertices) {
  EXPECT_NE(plyReaderMessageOf(header("ascii", "3") +
                               "0 255 0 0 0\n1 0 0 0 0\n0 0 1 0 0\n5\n3 0 2 1 0\n3 0 1 3 0\n3 0 3 2 0\n"
                               "3 1 2 3 0\n")
                .find("names vertex 3; there are 3"),
            std::string::npos);
}

TEST(PlyReader, RefusesAPointCloud) {
  EXPECT_EQ(
      plyReaderMessageOf(
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "end_header\n0 0 0\n"),
      "part.ply: no triangles");
}

TEST(PlyReader, RefusesVerticesWithoutZ) {
  EXPECT_NE(
      plyReaderMessageOf(
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n")
          .find("vertex 0 has no finite x, y and z"),
      std::string::npos);
}

}  // namespace
}  // namespace lamina
