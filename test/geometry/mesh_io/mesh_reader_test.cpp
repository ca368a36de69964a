// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

const std::vector<std::string> kSeeds = {
    "tetrahedron_binary.stl", "tetrahedron_ascii.stl",  "tetrahedron.obj", "tetrahedron_ascii.ply",
    "tetrahedron_big.ply",    "tetrahedron_little.ply", "tetrahedron.3mf"};

std::string bytesOf(const std::string& seed) {
  return readFile(std::string(LAMINA_SOURCE_DIR) + "/test/fuzz/corpus/mesh_reader_fuzz/" + seed);
}

/// Whatever the bytes are: a mesh that holds together, or InvalidMesh.
void expectMeshOrRefusal(const std::string& bytes, const std::string& name) {
  try {
    const Mesh mesh = readMeshFromBytes(bytes, name);
    RC_ASSERT(!mesh.triangles.empty());
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle) RC_ASSERT(v < mesh.vertices.size());
    for (const Point3& vertex : mesh.vertices) RC_ASSERT(vertex.allFinite());
  } catch (const InvalidMesh& error) {
    RC_ASSERT(std::string(error.what()).find(name) == 0u);
  }
}

class EveryFormat : public testing::TestWithParam<std::string> {};

TEST_P(EveryFormat, IsReportedByItsContent) {
  const Mesh mesh = readMeshFromBytes(bytesOf(GetParam()), "name-without-suffix");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-12);
}

TEST_P(EveryFormat, IsReportedByItsContentUnderAWrongSuffix) {
  EXPECT_NEAR(volume(readMeshFromBytes(bytesOf(GetParam()), "part.stl")), 1.0 / 6.0, 1e-12);
}

TEST_P(EveryFormat, IsScaled) {
  EXPECT_NEAR(volume(readMeshFromBytes(bytesOf(GetParam()), "part", {LengthUnit::Millimetre, 2.0})),
              8.0 / 6.0, 1e-12);
}

TEST_P(EveryFormat, IsReadOrRefusedWhereBytesAreWrong) {
  const std::string whole = bytesOf(GetParam());
  EXPECT_TRUE(rc::check("corrupted files are read or refused", [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::string bytes = whole.substr(0, random.below(4) == 0 ? random.below(whole.size()) : whole.size());
    for (std::uint64_t i = random.below(6); i > 0 && !bytes.empty(); --i)
      bytes[random.below(bytes.size())] = static_cast<char>(random.bits());
    expectMeshOrRefusal(bytes, GetParam());
  }));
}

INSTANTIATE_TEST_SUITE_P(Seeds, EveryFormat, testing::ValuesIn(kSeeds));

TEST(MeshReader, ReadsOrRefusesRandomBytes) {
  EXPECT_TRUE(rc::check("random bytes are read or refused", [](const std::string& bytes) {
    expectMeshOrRefusal(bytes, "part.stl");
    expectMeshOrRefusal(bytes, "part.obj");
    expectMeshOrRefusal("ply\n" + bytes, "part.ply");
  }));
}

TEST(MeshReader, RefusesAnEmptyFile) { EXPECT_THROW(readMeshFromBytes("", "part.stl"), InvalidMesh); }

TEST(MeshReader, RefusesWhatIsNoMesh) {
  EXPECT_THROW(readMeshFromBytes("Dear reader, this is a letter.\n", "letter.txt"), InvalidMesh);
  EXPECT_THROW(readMeshFromBytes(std::string(5000, 'x'), "letter.stl"), InvalidMesh);
}

TEST(MeshReader, RefusesAMissingFileAndAFolder) {
  EXPECT_THROW(readMesh("/nowhere/part.stl"), FileError);
  const test::ScratchFolder folder;
  EXPECT_THROW(readMesh(folder.file("")), FileError);
}

TEST(MeshReader, RefusesCoordinatesBeyondTheWorkshop) {
  EXPECT_THROW(readMeshFromBytes("v 1e12 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", "far.obj"), InvalidMesh);
  EXPECT_THROW(
      readMeshFromBytes("v 1e7 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", "far.obj", {LengthUnit::Metre, 1.0}),
      InvalidMesh);
}

TEST(MeshReader, KnowsItsUnits) {
  const std::string unit_length = "v 1 0 0\nv 0 0 0\nv 0 0 1\nf 1 2 3\n";
  const std::vector<double> millimetres = {1.0, 10.0, 1000.0, 25.4};
  for (std::size_t i = 0; i < lengthUnits().size(); ++i) {
    const Mesh mesh = readMeshFromBytes(unit_length, "a.obj", {lengthUnits()[i].second, 1.0});
    EXPECT_DOUBLE_EQ(boundingBox(mesh).size().x(), millimetres[i]) << lengthUnits()[i].first;
  }
}

}  // namespace
}  // namespace lamina
