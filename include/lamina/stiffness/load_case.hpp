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

/// A boundary condition: the nodes in a box of the lattice get a given displacement along the axis of the
/// load. It models a support (displacement 0), a plate or a punch.
struct HeldNodes {
  std::string name;              ///< such as "base" or "punch"
  std::array<int, 3> low{};      ///< indices of the first node along x, y, z
  std::array<int, 3> high{};     ///< indices of the last node along x, y, z, included
  double displacement_mm = 0.0;  ///< along the axis of the load, signed
};

/// A load on a part, with the dimensions from which the equivalent modulus follows.
struct LoadCase {
  int axis = 2;                  ///< axis of the load: 0, 1, 2 for x, y, z
  std::vector<HeldNodes> held;   ///< boundary conditions; solid that does not reach all of them bears no load
  double displacement_mm = 0.0;  ///< of the plate or punch, positive
  double length_mm = 0.0;        ///< of compression: height of the part; of bending: span on the lattice
  double area_mm2 = 0.0;         ///< of compression: cross-section
  double width_mm = 0.0;         ///< of bending: width of the beam
  double height_mm = 0.0;        ///< of bending: height of the beam, along the load
};

/// Makes the load case of the settings for a lattice that is the bounding box of its solid.
///
/// Compression holds the nodes of the lowest plane and displaces those of the highest plane, along the axis
/// only. Bending holds the two lines of nodes of the lowest plane that are nearest to the supports, and
/// displaces the line of the highest plane half way between them, as rigid cylinders do that touch along
/// these lines. The span is along the longer of the two axes across the load.
///
/// @throws InvalidConfig if the span does not fit on the part
LoadCase loadCase(const ElementLattice& lattice, double element_mm, const StiffnessSettings& settings);

/// Equivalent modulus [MPa] from the force [N] on the plate or punch.
double equivalentModulus(const LoadCase& load, Load kind, double force_n);

/// Numbers of the nodes of the lattice in the box of a boundary condition, ascending.
std::vector<std::int32_t> nodesOf(const ElementLattice& lattice, const HeldNodes& held);

}  // namespace lamina
