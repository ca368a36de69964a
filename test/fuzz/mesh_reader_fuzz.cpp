// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <cstdlib>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh/mesh_repair.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace {

/// What is read must have indices in range and finite vertices, and what is repaired must be closed.
void readAndRepair(std::string_view bytes, const char* name) {
  try {
    lamina::Mesh mesh = lamina::readMeshFromBytes(bytes, name);
    for (const lamina::Triangle& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle)
        if (v >= mesh.vertices.size() || !mesh.vertices[v].allFinite()) std::abort();
    const lamina::RepairResult repaired = lamina::repairMesh(std::move(mesh));
    if (lamina::pairHalfEdges(repaired.mesh).has_border || !(lamina::volume(repaired.mesh) > 0.0))
      std::abort();
  } catch (const lamina::InvalidMesh&) {
    // The ordinary answer to broken input; any other exception is a fault.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view view(reinterpret_cast<const char*>(bytes), size);
  readAndRepair(view, "fuzz");
  readAndRepair(view, "fuzz.stl");
  return 0;
}
