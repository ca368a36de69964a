// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/mesh_writer.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kRecord = 50;

Eigen::Vector3f rounded(const Point3& vertex) {
  if (!(vertex.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()))
    throw InvalidMesh("a coordinate is " + numberText(vertex.cwiseAbs().maxCoeff()) +
                      " mm; must fit a float");
  return vertex.cast<float>();
}

void appendRecord(std::string& bytes, const Mesh& mesh, const Triangle& t) {
  const Point3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                            .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                            .normalized();
  const Eigen::Vector3f numbers[4] = {normal.cast<float>(), rounded(mesh.vertices[t[0]]),
                                      rounded(mesh.vertices[t[1]]), rounded(mesh.vertices[t[2]])};
  bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  bytes.append(2, '\0');
}

}  // namespace

void writeStl(const std::string& path, const Mesh& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw InvalidMesh(std::to_string(mesh.triangles.size()) + " triangles; an STL holds at most 4294967295");
  // Not "solid": some readers take that for the ASCII form.
  std::string bytes = "Lamina binary STL, mm";
  bytes.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.reserve(bytes.size() + kRecord * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) appendRecord(bytes, mesh, triangle);
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace lamina
