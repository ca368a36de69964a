// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_topology.hpp"
#include "mesh_formats.hpp"
#include "vertex_welder.hpp"

namespace lamina {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kStart = 84;
constexpr std::size_t kRecord = 50;
constexpr std::size_t kNormal = 12;

using Welder = VertexWelder<float>;
using Corners = std::array<Welder::Coordinates, 3>;

std::uint32_t statedCount(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  return count;
}

Corners cornersOf(const char* record) {
  Corners corners;
  std::memcpy(corners.data(), record + kNormal, sizeof corners);
  return corners;
}

/// Whole triangles in blocks, so that the memory of a block's hash slots is on its way before it is asked
/// for.
Mesh weldRecords(const char* records, std::size_t count) {
  constexpr std::size_t kBlock = 16;
  Mesh mesh;
  mesh.triangles.resize(count);
  Welder welder(count / 2 + 4);
  std::array<Welder::Coordinates, 3 * kBlock> keys;
  std::array<std::uint64_t, 3 * kBlock> hashes;
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t size = std::min(kBlock, count - first);
    for (std::size_t i = 0; i < 3 * size; ++i) {
      std::memcpy(&keys[i], records + (first + i / 3) * kRecord + kNormal + (i % 3) * sizeof keys[i],
                  sizeof keys[i]);
      keys[i] = Welder::withoutNegativeZero(keys[i]);
      hashes[i] = Welder::hash(keys[i]);
      welder.prefetch(hashes[i]);
    }
    for (std::size_t i = 0; i < 3 * size; ++i)
      mesh.triangles[first + i / 3][i % 3] = welder.add(keys[i], hashes[i]);
  }
  mesh.vertices = welder.vertices();
  return mesh;
}

void refuseNonFinite(std::string_view bytes, std::size_t count, const std::string& name) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = kStart + i * kRecord;
    for (const auto& corner : cornersOf(bytes.data() + offset))
      for (const float value : corner)
        if (!std::isfinite(value))
          throw InvalidMesh(name + ": triangle " + std::to_string(i) + " at byte " + std::to_string(offset) +
                            " has the coordinate " + std::to_string(value) + "; must be finite");
  }
}

bool isFinite(const Mesh& mesh) {
  for (const Point3& vertex : mesh.vertices)
    if (!vertex.allFinite()) return false;
  return true;
}

/// The number of triangles to read: as stated, or as many as there are if the file holds more whole ones.
std::size_t countToRead(std::string_view bytes, const std::string& name) {
  const std::size_t stated = statedCount(bytes);
  const std::size_t held = (bytes.size() - kStart) / kRecord;
  const std::size_t rest = (bytes.size() - kStart) % kRecord;
  if (stated == held &&
      bytes.find_first_not_of(std::string_view("\0\r\n ", 4), bytes.size() - rest) == bytes.npos)
    return held;
  if (rest != 0)
    throw InvalidMesh(name + ": truncated or no binary STL: " + std::to_string(bytes.size()) + " bytes; " +
                      std::to_string(stated) + " triangles need " +
                      std::to_string(kStart + kRecord * stated));
  return held;
}

}  // namespace

bool isExactBinaryStl(std::string_view bytes) {
  return bytes.size() >= kStart && bytes.size() == kStart + kRecord * statedCount(bytes);
}

Mesh readBinaryStl(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kStart)
    throw InvalidMesh(name + ": truncated: " + std::to_string(bytes.size()) +
                      " bytes; the header of a binary STL has 84");
  const std::size_t count = countToRead(bytes, name);
  Mesh mesh = weldRecords(bytes.data() + kStart, count);
  if (!isFinite(mesh)) refuseNonFinite(bytes, count, name);
  if (statedCount(bytes) > count && (count == 0 || pairHalfEdges(mesh).has_border))
    throw InvalidMesh(name + ": truncated at byte " + std::to_string(bytes.size()) + ": " +
                      std::to_string(count) + " triangles, which leave holes; the header states " +
                      std::to_string(statedCount(bytes)));
  return mesh;
}

}  // namespace lamina
