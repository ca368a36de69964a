// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "mesh_formats.hpp"
#include "vertex_welder.hpp"

namespace lamina {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kStart = kBinaryStlStart;
constexpr std::size_t kReadRecord = 50;
constexpr std::size_t kNormal = 12;

using Welder = VertexWelder<float>;

std::uint32_t statedCount(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  return count;
}

/// Welds records as they come, in blocks, so that the memory of a block's hash slots is on its way before it
/// is asked for.
class RecordWelder {
 public:
  explicit RecordWelder(std::size_t expected) : welder_(expected / 2 + 4) {
    mesh_.triangles.reserve(expected);
  }

  void add(const char* records, std::size_t count) {
    for (std::size_t first = 0; first < count; first += kBlock)
      addBlock(records + first * kReadRecord, std::min(kBlock, count - first));
  }

  /// @throws InvalidMesh if a coordinate is not finite
  Mesh mesh(const std::string& name) && {
    mesh_.vertices = welder_.vertices();
    for (const Point3& vertex : mesh_.vertices)
      if (!vertex.allFinite()) refuseNonFinite(name);
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kBlock = 16;

  void addBlock(const char* records, std::size_t count) {
    std::array<Welder::Key, 3 * kBlock> keys;
    std::array<std::uint64_t, 3 * kBlock> hashes;
    for (std::size_t i = 0; i < 3 * count; ++i) {
      Welder::Coordinates corner;
      std::memcpy(corner.data(), records + i / 3 * kReadRecord + kNormal + i % 3 * sizeof corner,
                  sizeof corner);
      keys[i] = Welder::keyOf(corner);
      hashes[i] = Welder::hash(keys[i]);
      welder_.prefetch(hashes[i]);
    }
    for (std::size_t i = 0; i < 3 * count; i += 3)
      mesh_.triangles.push_back({welder_.add(keys[i], hashes[i]), welder_.add(keys[i + 1], hashes[i + 1]),
                                 welder_.add(keys[i + 2], hashes[i + 2])});
  }

  [[noreturn]] void refuseNonFinite(const std::string& name) const {
    std::size_t t = 0;
    const auto is_finite = [&](std::uint32_t v) { return mesh_.vertices[v].allFinite(); };
    while (std::all_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), is_finite)) ++t;
    const Triangle& corners = mesh_.triangles[t];
    const auto corner = std::find_if_not(corners.begin(), corners.end(), is_finite);
    const Point3& vertex = mesh_.vertices[*corner];
    const auto axis =
        std::find_if_not(vertex.begin(), vertex.end(), [](double c) { return std::isfinite(c); });
    throw InvalidMesh(name + ": triangle " + std::to_string(t) + " at byte " +
                      std::to_string(kStart + t * kReadRecord) + ": " + "xyz"[axis - vertex.begin()] +
                      " of corner " + std::to_string(corner - corners.begin()) + " is " + numberText(*axis) +
                      "; expected a finite number");
  }

  Welder welder_;
  Mesh mesh_;
};

/// The number of triangles to read: as stated, or as many as there are if the file holds more whole ones.
std::size_t countToRead(std::string_view bytes, const std::string& name) {
  const std::size_t stated = statedCount(bytes);
  const std::size_t held = (bytes.size() - kStart) / kReadRecord;
  const std::size_t rest = (bytes.size() - kStart) % kReadRecord;
  if (stated == held &&
      bytes.find_first_not_of(std::string_view("\0\r\n ", 4), bytes.size() - rest) == bytes.npos)
    return held;
  if (rest != 0)
    throw InvalidMesh(
        name + ": neither an STL of text (solid, facet, ... endsolid) nor a whole binary one: " +
        std::to_string(bytes.size()) + " bytes; the " + std::to_string(stated) +
        " triangles that its header states need " + std::to_string(kStart + kReadRecord * stated));
  return held;
}

}  // namespace

bool isExactBinaryStl(std::string_view start, std::size_t size) {
  return start.size() >= kStart && size == kStart + kReadRecord * statedCount(start);
}

Mesh readExactBinaryStl(InputFile& file, std::string_view start, const std::string& name) {
  constexpr std::size_t kRecords = 4096;
  const std::size_t count = statedCount(start);
  RecordWelder welder(count);
  std::vector<char> buffer(kReadRecord * kRecords);
  for (std::size_t first = 0; first < count; first += kRecords) {
    const std::size_t wanted = std::min(kRecords, count - first);
    if (file.read(buffer.data(), wanted * kReadRecord) != wanted * kReadRecord)
      throw InvalidMesh(name + ": truncated while it was read");
    welder.add(buffer.data(), wanted);
  }
  return std::move(welder).mesh(name);
}

Mesh readBinaryStl(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kStart)
    throw InvalidMesh(name + ": truncated or no STL: " + std::to_string(bytes.size()) +
                      " bytes; the header of a binary STL has 84");
  const std::size_t count = countToRead(bytes, name);
  RecordWelder welder(count);
  welder.add(bytes.data() + kStart, count);
  Mesh mesh = std::move(welder).mesh(name);
  if (statedCount(bytes) > count && !isClosedSurface(mesh))
    throw InvalidMesh(name + ": truncated at byte " + std::to_string(bytes.size()) + ": " +
                      std::to_string(count) + " triangles, which leave holes; the header states " +
                      std::to_string(statedCount(bytes)));
  return mesh;
}

}  // namespace lamina
