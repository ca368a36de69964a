// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness_vtk.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "stiffness/buffered_file.hpp"
#include "stiffness/element_nodes.hpp"

namespace lamina {
namespace {

constexpr std::int32_t kHexahedron = 12;  // number of the cell in VTK

/// Text and numbers of four bytes, most significant first, as legacy VTK files have them.
class VtkFile {
 public:
  explicit VtkFile(const std::string& path) : file_(path) {}

  void text(const std::string& line) { file_.append(line); }
  template <class Number>
  void number(Number value) {
    static_assert(sizeof(Number) == 4);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &value, 4);
    std::reverse(bytes.begin(), bytes.end());
    file_.append(bytes);
  }
  void commit() { file_.commit(); }

 private:
  BufferedFile file_;
};

void writeGrid(const ElementModel& model, VtkFile& file) {
  const ElementLattice& lattice = model.lattice;
  const std::string elements = std::to_string(lattice.elementCount());
  file.text(
      "# vtk DataFile Version 3.0\nstiffness of a part, mm and MPa\nBINARY\nDATASET UNSTRUCTURED_GRID\n");
  file.text("POINTS " + std::to_string(lattice.nodeCount()) + " float\n");
  forNodes(lattice, [&](std::int32_t, int i, int j, int k) {
    const Point3 place = placeOf(model, i, j, k);
    for (Eigen::Index axis = 0; axis < 3; ++axis) file.number(static_cast<float>(place[axis]));
  });
  file.text("\nCELLS " + elements + " " + std::to_string(9 * lattice.elementCount()) + "\n");
  forElements(lattice, [&](const ElementRun& run, std::int32_t i) {
    file.number(std::int32_t{8});
    for (const std::int32_t node : nodesAround(run, i)) file.number(node);
  });
  file.text("\nCELL_TYPES " + elements + "\n");
  for (std::int64_t i = 0; i < lattice.elementCount(); ++i) file.number(kHexahedron);
}

void writeFields(const StiffnessResult& result, VtkFile& file) {
  const ElementLattice& lattice = result.model.lattice;
  const std::string elements = std::to_string(lattice.elementCount());
  file.text("\nPOINT_DATA " + std::to_string(lattice.nodeCount()) + "\nVECTORS displacement_mm float\n");
  for (std::size_t node = 0; node < result.displacement.size(); ++node)
    for (const auto& component : result.displacement.along) file.number(static_cast<float>(component[node]));
  file.text("\nCELL_DATA " + elements + "\nSCALARS von_mises_mpa float 1\nLOOKUP_TABLE default\n");
  for (const Stress& stress : result.stress) file.number(stress.vonMises());
  file.text("\nFIELD stress 1\nstress_mpa 6 " + elements + " float\n");
  for (const Stress& s : result.stress)
    for (const float component : {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}) file.number(component);
  file.text("\n");
}

}  // namespace

void writeVtk(const StiffnessResult& result, const std::string& path) {
  VtkFile file(path);
  writeGrid(result.model, file);
  writeFields(result, file);
  file.commit();
}

}  // namespace lamina
