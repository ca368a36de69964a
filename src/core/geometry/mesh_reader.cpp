// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_reader.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "mesh_formats.hpp"

namespace lamina {
namespace {

double millimetresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Millimetre:
      return 1.0;
    case LengthUnit::Centimetre:
      return 10.0;
    case LengthUnit::Metre:
      return 1000.0;
    case LengthUnit::Inch:
      return 25.4;
  }
  return 1.0;
}

std::string lowerSuffix(const std::string& name) {
  const std::size_t dot = name.find_last_of("./");
  if (dot == std::string::npos || name[dot] != '.') return {};
  std::string suffix = name.substr(dot);
  for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return suffix;
}

Mesh readInFileUnits(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) throw InvalidMesh(name + ": empty file; expected a mesh (STL, OBJ, PLY or 3MF)");
  if (isPly(bytes)) return readPly(bytes, name);
  if (isExactBinaryStl(bytes)) return readBinaryStl(bytes, name);
  if (isAsciiStl(bytes)) return readAsciiStl(bytes, name);
  if (isObj(bytes)) return readObj(bytes, name);
  if (lowerSuffix(name) == ".stl") return readBinaryStl(bytes, name);
  throw InvalidMesh(name + ": not a mesh: neither STL, OBJ, PLY nor 3MF");
}

void convertToMillimetres(Mesh& mesh, double factor, const std::string& name) {
  // Beyond this, areas and volumes lose their meaning long before they overflow.
  constexpr double kFarthest = 1e9;
  for (Point3& vertex : mesh.vertices) {
    vertex *= factor;
    const double farthest = vertex.cwiseAbs().maxCoeff();
    if (!(farthest <= kFarthest))
      throw InvalidMesh(name + ": a vertex lies at " + std::to_string(farthest) +
                        " mm; must be within 1e9 mm");
  }
}

}  // namespace

const std::vector<std::pair<std::string, LengthUnit>>& lengthUnits() {
  static const std::vector<std::pair<std::string, LengthUnit>> kUnits = {{"mm", LengthUnit::Millimetre},
                                                                         {"cm", LengthUnit::Centimetre},
                                                                         {"m", LengthUnit::Metre},
                                                                         {"inch", LengthUnit::Inch}};
  return kUnits;
}

Mesh readMesh(const std::string& path, const MeshUnits& units) {
  return readMeshFromBytes(readFile(path), path, units);
}

Mesh readMeshFromBytes(std::string_view bytes, const std::string& name, const MeshUnits& units) {
  if (!(units.scale > 0.0) || !std::isfinite(units.scale))
    throw InvalidConfig("scale is " + std::to_string(units.scale) + "; must be positive and finite");
  const bool states_unit = isThreemf(bytes);
  Mesh mesh = states_unit ? readThreemf(bytes, name) : readInFileUnits(bytes, name);
  if (mesh.triangles.empty()) throw InvalidMesh(name + ": no triangles");
  convertToMillimetres(mesh, units.scale * (states_unit ? 1.0 : millimetresPer(units.unit)), name);
  return mesh;
}

}  // namespace lamina
