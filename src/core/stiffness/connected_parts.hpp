// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/load_case.hpp"

namespace lamina {

/// Elements that hang together face by face. An edge or corner in common is a hinge, and no connection.
struct ConnectedPart {
  std::int64_t elements = 0;
  std::array<int, 3> low{};   ///< element of the lattice, included
  std::array<int, 3> high{};  ///< excluded
  std::vector<bool> reaches;  ///< of what is held, in its order: whether the part has nodes there
  bool reachesAll() const;
};

struct ConnectedParts {
  std::vector<std::int32_t> part_of_run;  ///< in the order of the runs of the lattice
  std::vector<ConnectedPart> parts;       ///< in the order of their first elements
};

ConnectedParts connectedParts(const ElementLattice& lattice, const std::vector<HeldNodes>& held);

}  // namespace lamina
