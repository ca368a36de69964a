// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

#include <array>
#include <cmath>

#include "base/module.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/mesh_io/mesh_objects.hpp"
#include "mesh_formats.hpp"
#include "step_module.hpp"
#include "threemf_module.hpp"

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
  if (bytes.empty()) throw InvalidMesh(name + ": empty file; expected a mesh (STL, OBJ, PLY, 3MF or STEP)");
  if (!isPly(bytes) && isExactBinaryStl(bytes, bytes.size())) return readBinaryStl(bytes, name);
  const std::string_view text = withoutUtf8Mark(bytes);
  if (isPly(text)) return readPly(text, name);
  if (isAsciiStl(text)) return readAsciiStl(text, name);
  if (isObj(text)) return readObj(text, name);
  if (lowerSuffix(name) == ".stl") return readBinaryStl(bytes, name);
  throw InvalidMesh(name + ": not a mesh: neither STL, OBJ, PLY, 3MF nor STEP");
}

double factorOf(const MeshUnits& units) {
  if (!(units.scale > 0.0) || !std::isfinite(units.scale))
    throw InvalidConfig("scale is " + numberText(units.scale) + "; must be positive and finite");
  return units.scale * millimetresPer(units.unit);
}

Mesh inMillimetres(Mesh mesh, double factor, const std::string& name) {
  // Beyond this, areas and volumes lose their meaning long before they overflow.
  constexpr double kFarthest = 1e9;
  if (mesh.triangles.empty()) throw InvalidMesh(name + ": no triangles");
  for (Point3& vertex : mesh.vertices) {
    vertex *= factor;
    const double farthest = vertex.cwiseAbs().maxCoeff();
    if (!(farthest <= kFarthest))
      throw InvalidMesh(name + ": a vertex lies at " + numberText(farthest) + " mm; must be within 1e9 mm");
  }
  return mesh;
}

std::vector<MeshVolume> inMillimetres(std::vector<MeshVolume> volumes, double factor,
                                      const std::string& name) {
  for (MeshVolume& volume : volumes) volume.mesh = inMillimetres(std::move(volume.mesh), factor, name);
  return volumes;
}

/// The module of Open CASCADE, which not every build has, nor every machine what it links to.
std::vector<MeshObject> readStepSolids(std::string_view bytes, const std::string& name,
                                       const Tessellation& tessellation, Progress& progress) {
  try {
    const auto* const module = static_cast<const StepModule*>(moduleTable("step"));
    return module->read_solids(bytes, name, tessellation, progress);
  } catch (const FileError& error) {
    throw FileError(name +
                    ": STEP files are read by Open CASCADE, which is not here; install "
                    "libocct-data-exchange-dev and build Lamina with it, or mesh the file first (" +
                    error.what() + ")");
  }
}

/// All solids as one mesh.
Mesh readStep(std::string_view bytes, const std::string& name, const Tessellation& tessellation,
              Progress& progress) {
  Mesh all;
  for (const MeshObject& solid : readStepSolids(bytes, name, tessellation, progress)) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), solid.mesh.vertices.begin(), solid.mesh.vertices.end());
    for (const Triangle& triangle : solid.mesh.triangles)
      all.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }
  return all;
}

std::vector<MeshObject> readObjectsOf(std::string_view bytes, const std::string& path,
                                      const Tessellation& tessellation, Progress& progress) {
  if (isStep(bytes)) return readStepSolids(bytes, path, tessellation, progress);
  return static_cast<const ThreemfModule*>(moduleTable("threemf"))->read_objects(bytes, path);
}

Mesh meshFromBytes(std::string_view bytes, const std::string& name, const MeshUnits& units,
                   const Tessellation& tessellation, Progress& progress) {
  if (!isThreemf(bytes) && !isStep(bytes))
    return inMillimetres(readInFileUnits(bytes, name), factorOf(units), name);
  const double factor = factorOf({LengthUnit::Millimetre, units.scale});
  return inMillimetres(
      isStep(bytes) ? readStep(bytes, name, tessellation, progress) : readThreemf(bytes, name), factor, name);
}

}  // namespace

bool isStep(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && bytes.substr(start, 12) == "ISO-10303-21";
}

bool isThreemf(std::string_view bytes) { return bytes.substr(0, 4) == "PK\x03\x04"; }

Mesh readThreemf(std::string_view bytes, const std::string& name) {
  return static_cast<const ThreemfModule*>(moduleTable("threemf"))->read(bytes, name);
}

const std::vector<std::pair<std::string, LengthUnit>>& lengthUnits() {
  static const std::vector<std::pair<std::string, LengthUnit>> units = {{"mm", LengthUnit::Millimetre},
                                                                        {"cm", LengthUnit::Centimetre},
                                                                        {"m", LengthUnit::Metre},
                                                                        {"inch", LengthUnit::Inch}};
  return units;
}

bool isClosedSurface(const Mesh& mesh) { return !pairHalfEdges(mesh).has_border && volume(mesh) != 0.0; }

Mesh readMesh(const std::string& path, const MeshUnits& units, const Tessellation& tessellation) {
  NoProgress nobody;
  return readMesh(path, units, tessellation, nobody);
}

Mesh readMesh(const std::string& path, const MeshUnits& units, const Tessellation& tessellation,
              Progress& progress) {
  InputFile file(path);
  std::array<char, kBinaryStlStart> buffer;
  const std::string_view start(buffer.data(), file.read(buffer.data(), buffer.size()));
  if (isPly(start) || !isExactBinaryStl(start, file.size()))
    return meshFromBytes(file.readRest(start), path, units, tessellation, progress);
  return inMillimetres(readExactBinaryStl(file, start, path), factorOf(units), path);
}

std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units,
                                        const Tessellation& tessellation) {
  NoProgress nobody;
  return readMeshObjects(path, units, tessellation, nobody);
}

std::vector<MeshObject> readMeshObjects(const std::string& path, const MeshUnits& units,
                                        const Tessellation& tessellation, Progress& progress) {
  InputFile file(path);
  std::array<char, kBinaryStlStart> buffer;
  const std::string_view start(buffer.data(), file.read(buffer.data(), buffer.size()));
  std::vector<MeshObject> objects;
  if (!isThreemf(start) && !isStep(start)) {
    objects.push_back({"", readMesh(path, units)});
    return objects;
  }
  const double factor = factorOf({LengthUnit::Millimetre, units.scale});
  objects = readObjectsOf(file.readRest(start), path, tessellation, progress);
  for (MeshObject& object : objects) {
    object.mesh = inMillimetres(std::move(object.mesh), factor, path);
    object.volumes = inMillimetres(std::move(object.volumes), factor, path);
  }
  return objects;
}

std::vector<MeshVolume> readMeshVolumes(const std::string& path, const MeshUnits& units) {
  InputFile file(path);
  std::array<char, 4> buffer{};
  const std::string_view start(buffer.data(), file.read(buffer.data(), buffer.size()));
  if (!isThreemf(start)) return {};
  const auto* const module = static_cast<const ThreemfModule*>(moduleTable("threemf"));
  return inMillimetres(module->read_volumes(file.readRest(start), path),
                       factorOf({LengthUnit::Millimetre, units.scale}), path);
}

Mesh readMeshFromBytes(std::string_view bytes, const std::string& name, const MeshUnits& units,
                       const Tessellation& tessellation) {
  NoProgress nobody;
  return meshFromBytes(bytes, name, units, tessellation, nobody);
}

}  // namespace lamina
