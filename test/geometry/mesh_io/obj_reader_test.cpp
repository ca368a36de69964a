// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {
namespace {

/// A pyramid of volume 4/3 on a square of side 2.
const std::string kVertices = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1 1.0\n";

std::string messageOf(const std::string& text) {
  try {
    readMeshFromBytes(text, "part.obj");
  } catch (const InvalidMesh& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ObjReader, FansPolygons) {
  const Mesh mesh =
      readMeshFromBytes("# a comment\n" + kVertices + "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n", "a");
  EXPECT_EQ(mesh.triangles.size(), 6u);
  EXPECT_NEAR(volume(mesh), 4.0 / 3.0, 1e-15);
}

/// The first vertex was passed over, and every face then named the one after its own.
TEST(ObjReader, LeavesOutTheMarkOfUtf8) {
  const Mesh mesh = readMeshFromBytes(
      "\xEF\xBB\xBF" + kVertices + "v 9 9 9\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n", "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 5u);
  EXPECT_NEAR(volume(mesh), 4.0 / 3.0, 1e-15);
}

TEST(ObjReader, TakesTextureAndNormalIndicesAndIgnoresThem) {
  const Mesh mesh = readMeshFromBytes(kVertices +
                                          "vt 0 0\nvn 0 0 1\nf 4/1/1 3/1/1 2/1/1 1/1/1\nf 1//1 2//1 5//1\nf "
                                          "2/1 3/1 5/1\nf 3 4 5 # end\nf 4 1 5",
                                      "a.obj");
  EXPECT_NEAR(volume(mesh), 4.0 / 3.0, 1e-15);
}

TEST(ObjReader, CountsNegativeIndicesFromTheLastVertex) {
  const Mesh mesh = readMeshFromBytes(
      kVertices + "f -2 -3 -4 -5\r\nf -5 -4 -1\r\nf -4 -3 -1\r\nf -3 -2 -1\r\nf -2 -5 -1\r\n", "a.obj");
  EXPECT_NEAR(volume(mesh), 4.0 / 3.0, 1e-15);
}

TEST(ObjReader, WeldsRepeatedAndDropsUnusedVertices) {
  const Mesh mesh =
      readMeshFromBytes("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nf 2 3 4\nf 5 4 3\n", "a.obj");
  EXPECT_EQ(mesh.vertices.size(), 3u);
}

TEST(ObjReader, IsNotMistakenForAnStlByItsComments) {
  EXPECT_EQ(readMeshFromBytes("# solid: facet and vertex\n" + kVertices + "f 1 2 5\n", "a").triangles.size(),
            1u);
}

TEST(ObjReader, NamesTheLineOfABrokenFace) {
  EXPECT_EQ(messageOf(kVertices + "f 1 2 x\n"),
            "part.obj:6: a face names no vertex by 'x'; there are 5 so far");
  EXPECT_NE(messageOf(kVertices + "f 1 2\n").find("part.obj:6: a face with 2 corners"), std::string::npos);
  EXPECT_NE(messageOf(kVertices + "f 1 2 -6\n").find("part.obj:6"), std::string::npos);
}

TEST(ObjReader, RefusesIndicesBeyondTheVertices) {
  EXPECT_NE(messageOf(kVertices + "f 1 2 6\n").find("names vertex 5; there are 5"), std::string::npos);
}

TEST(ObjReader, RefusesNumbersThatAreNotFinite) {
  EXPECT_NE(messageOf("v 0 0 inf\nf 1 1 1\n").find("part.obj:1"), std::string::npos);
  EXPECT_NE(messageOf("v 0 0\nf 1 1 1\n").find("part.obj:1"), std::string::npos);
}

TEST(ObjReader, RefusesAFileWithoutFaces) { EXPECT_EQ(messageOf(kVertices), "part.obj: no triangles"); }

}  // namespace
}  // namespace lamina
