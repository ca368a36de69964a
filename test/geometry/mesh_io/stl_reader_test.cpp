// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {
namespace {

using Corner = std::array<float, 3>;

std::string binaryStl(const std::vector<Corner>& corners, std::uint32_t count,
                      const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(&corners[i]), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

/// A tetrahedron of volume 1/6.
std::vector<Corner> tetrahedron() {
  const Corner o = {0, 0, 0}, x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  return {o, y, x, o, x, z, o, z, y, x, y, z};
}

std::string asciiFacet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

std::string stlReaderMessageOf(const std::string& bytes, const std::string& name = "part.stl") {
  try {
    readMeshFromBytes(bytes, name);
  } catch (const InvalidMesh& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StlReader, WeldsTheCornersOfABinaryFile) {
  const Mesh mesh = readMeshFromBytes(binaryStl(tetrahedron(), 4), "part.stl");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-15);
}

TEST(StlReader, TakesABinaryFileThatStartsWithSolid) {
  EXPECT_EQ(readMeshFromBytes(binaryStl(tetrahedron(), 4, "solid facet vertex"), "part.stl").triangles.size(),
            4u);
}

TEST(StlReader, TakesNegativeZeroForZero) {
  auto corners = tetrahedron();
  corners[0] = {-0.0f, 0.0f, -0.0f};
  EXPECT_EQ(readMeshFromBytes(binaryStl(corners, 4), "part.stl").vertices.size(), 4u);
}

TEST(StlReader, CorrectsACountThatTheFileContradicts) {
  for (const std::uint32_t count : {0u, 3u, 5u, 0xFFFFFFFFu})
    EXPECT_EQ(readMeshFromBytes(binaryStl(tetrahedron(), count), "part.stl").triangles.size(), 4u) << count;
}

TEST(StlReader, RefusesAFileCutBetweenTwoTriangles) {
  auto corners = tetrahedron();
  corners.resize(9);
  EXPECT_NE(stlReaderMessageOf(binaryStl(corners, 4)).find("truncated at byte 234"), std::string::npos);
}

TEST(StlReader, RefusesAHugeCountBeforeATriangleWithoutCorners) {
  EXPECT_NE(stlReaderMessageOf(binaryStl({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 0xFFFFFFFFu)).find("truncated"),
            std::string::npos);
}

TEST(StlReader, RefusesEveryShorterPieceOfABinaryFile) {
  const std::string whole = binaryStl(tetrahedron(), 4);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(stlReaderMessageOf(whole.substr(0, length)), "accepted") << length;
}

TEST(StlReader, NamesTheTriangleWhoseCoordinateIsNotFinite) {
  auto corners = tetrahedron();
  corners[4][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(stlReaderMessageOf(binaryStl(corners, 4)),
            "part.stl: triangle 1 at byte 134: y of corner 1 is nan; expected a finite number");
}

TEST(StlReader, ReadsAsciiOfOddCaseAndSpacing) {
  const std::string text = "  SOLID a facet of vertex\r\n" + asciiFacet("0 0 0", "0 +1.0e0 0", "1 0 0") +
                           asciiFacet("0\t0  0", "1. 0 0", "0 0 1") + asciiFacet("0 0 0", "0 0 1", "0 1 0") +
                           asciiFacet("1 0 0", "0 1 0", "0 0 1.000") + " EndSolid\r\n";
  const Mesh mesh = readMeshFromBytes(text, "part.stl");
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-15);
}

TEST(StlReader, ReadsAsciiWithAForeignHeader) {
  const std::string text = "made by hand\n" + asciiFacet("0 0 0", "0 1 0", "1 0 0") + "endsolid\n";
  EXPECT_EQ(readMeshFromBytes(text, "part").triangles.size(), 1u);
}

TEST(StlReader, NamesTheLineOfAnAsciiError) {
  EXPECT_EQ(stlReaderMessageOf("solid\n" + asciiFacet("0 0 0", "0 nan 0", "1 0 0") + "endsolid\n"),
            "part.stl:5: 'nan' where a finite number is expected");
}

TEST(StlReader, RefusesAnAsciiSolidWithoutFacets) {
  EXPECT_EQ(stlReaderMessageOf("solid nothing\nendsolid nothing\n"), "part.stl: no triangles");
}

TEST(StlReader, RefusesAsciiWithoutItsEnd) {
  EXPECT_NE(stlReaderMessageOf("solid\n" + asciiFacet("0 0 0", "0 1 0", "1 0 0")).find("truncated"),
            std::string::npos);
}

TEST(StlReader, AppliesUnitAndScale) {
  const Mesh mesh = readMeshFromBytes(binaryStl(tetrahedron(), 4), "part.stl", {LengthUnit::Inch, 2.0});
  EXPECT_DOUBLE_EQ(boundingBox(mesh).size().x(), 50.8);
}

TEST(StlReader, RefusesAScaleOfZero) {
  EXPECT_THROW(readMeshFromBytes(binaryStl(tetrahedron(), 4), "part.stl", {LengthUnit::Millimetre, 0.0}),
               InvalidConfig);
}

}  // namespace
}  // namespace lamina
