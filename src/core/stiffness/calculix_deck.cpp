// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/calculix_deck.hpp"

#include <cstdio>
#include <utility>

#include "stiffness/buffered_file.hpp"
#include "stiffness/element_nodes.hpp"

namespace lamina {
namespace {

// Eight nodes, fully integrated, strain linear as it follows from the displacements.
constexpr const char* kElement = "C3D8";

/// Lines of a deck.
class Deck {
 public:
  explicit Deck(const std::string& path) : file_(path) {}

  void line(const std::string& text) { file_.append(text + '\n'); }
  void commit() { file_.commit(); }

 private:
  BufferedFile file_;
};

std::string exact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::string number(std::int32_t from_zero) { return std::to_string(from_zero + 1); }

void writeMesh(const ElementModel& model, Deck& deck) {
  deck.line("*NODE, NSET=NALL");
  forNodes(model.lattice, [&](std::int32_t node, int i, int j, int k) {
    const Point3 place = placeOf(model, i, j, k);
    deck.line(number(node) + ", " + exact(place.x()) + ", " + exact(place.y()) + ", " + exact(place.z()));
  });
  deck.line(std::string("*ELEMENT, TYPE=") + kElement + ", ELSET=EALL");
  std::int32_t element = 0;
  forElements(model.lattice, [&](const ElementRun& run, std::int32_t i) {
    std::string text = number(element++);
    for (const std::int32_t node : nodesAround(run, i)) text += ", " + number(node);
    deck.line(text);
  });
}

void writeLoad(const StiffnessResult& result, Deck& deck) {
  const ElementModel& model = result.model;
  deck.line("*NSET, NSET=REST");
  for (const HeldNodes& held : model.load.held)
    if (held.displacement_mm == 0.0)
      for (const std::int32_t node : nodesOf(model.lattice, held)) deck.line(number(node));
  deck.line("*STEP");
  deck.line("*STATIC");
  deck.line("*BOUNDARY");
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::int32_t node : result.given[axis]) {
      const std::string along = ", " + std::to_string(axis + 1);
      deck.line(number(node) + along + along + ", " +
                exact(result.displacement.along[axis][static_cast<std::size_t>(node)]));
    }
  deck.line("*NODE PRINT, NSET=NALL");
  deck.line("U");
  deck.line("*NODE PRINT, NSET=REST, TOTALS=ONLY");
  deck.line("RF");
  deck.line("*END STEP");
}

}  // namespace

void writeCalculixDeck(const StiffnessResult& result, const ElasticMaterial& material,
                       const std::string& path) {
  Deck deck(path);
  deck.line("** Part as voxels under load: mm, N, MPa");
  writeMesh(result.model, deck);
  deck.line("*MATERIAL, NAME=PART");
  deck.line("*ELASTIC");
  deck.line(exact(material.youngs_modulus_mpa) + ", " + exact(material.poissons_ratio));
  deck.line("*SOLID SECTION, ELSET=EALL, MATERIAL=PART");
  writeLoad(result, deck);
  deck.commit();
}

}  // namespace lamina
