// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/mesh_writer.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

const Mesh kTetrahedron = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}};

TEST(MeshWriter, WritesWhatTheReaderReads) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("written.stl");
  writeStl(path, kTetrahedron);
  const Mesh mesh = readMesh(path);
  EXPECT_EQ(mesh.vertices, kTetrahedron.vertices);
  EXPECT_EQ(mesh.triangles, kTetrahedron.triangles);
}

TEST(MeshWriter, LeavesTheOldFileIfACoordinateDoesNotFit) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("kept.stl");
  std::ofstream(path) << "old";
  Mesh mesh = kTetrahedron;
  mesh.vertices[0].x() = 1e300;
  EXPECT_THROW(writeStl(path, mesh), InvalidMesh);
  std::string content;
  std::ifstream(path) >> content;
  EXPECT_EQ(content, "old");
}

TEST(MeshWriter, RefusesAFolderThatIsNotThere) {
  EXPECT_THROW(writeStl("/nowhere/part.stl", kTetrahedron), FileError);
}

}  // namespace
}  // namespace lamina
