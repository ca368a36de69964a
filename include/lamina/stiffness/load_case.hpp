// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "lamina/stiffness/stiffness_settings.hpp"

namespace lamina {

/// Nodes in a box of the lattice that are displaced by as much, along the axis of the load.
struct HeldNodes {
  std::string name;
  std::array<int, 3> low{};   ///< node of the lattice, included
  std::array<int, 3> high{};  ///< included
  double displacement_mm = 0.0;
};

/// What is done to a part, and what follows for its modulus.
struct LoadCase {
  int axis = 2;                  ///< of the load and of the displacements
  std::vector<HeldNodes> held;   ///< every part of the solid that bears the load reaches all of them
  double displacement_mm = 0.0;  ///< of the plate or punch, positive
  double length_mm = 0.0;        ///< height of the part, or span between the supports as it is on the lattice
  double area_mm2 = 0.0;         ///< section under compression
  double width_mm = 0.0;         ///< of the beam
  double height_mm = 0.0;        ///< of the beam, along the load
};

/// The load on a lattice that fits its solid closely.
///
/// Compression holds the nodes of the lowest plane and displaces those of the highest, along the axis alone.
/// Bending holds the lines of nodes on the lowest plane nearest to the supports and displaces the line on the
/// highest plane half way between them: a rigid cylinder that touches along a line. The supports lie apart
/// along the longer of the two other axes.
///
/// @throws InvalidConfig if the span does not lie on the part
LoadCase loadCase(const ElementLattice& lattice, double element_mm, const StiffnessSettings& settings);

/// Equivalent modulus [MPa] from the force [N] of the plate or punch.
double equivalentModulus(const LoadCase& load, Load kind, double force_n);

/// Nodes of the lattice in the box, in rising order.
std::vector<std::int32_t> nodesOf(const ElementLattice& lattice, const HeldNodes& held);

}  // namespace lamina
