// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// A field over nodes and its gradients.
struct FieldAlong {
  const CellGraph& cells;
  const std::vector<double>& value;
  const std::vector<Point3>& gradient;  ///< 0 where there is none
  const std::vector<char>& is_given;    ///< nodes whose gradient is only roughly known, as at ends
};

/// Gradient lengths, by node, of another field with the directions and level surfaces of the given one, but
/// as evenly steep as possible: over each connected level surface, lengths are proportional to those of the
/// field, and as near to 1 as possible by least squares. A bent tube of radius r about R thus gets c /
/// distance from the axis of the bend, where c = (R + sqrt(R² - r²)) / 2. Level surfaces are taken in bands
/// three cells thick. Lengths within a thousandth of 1 are 1; so are lengths at nodes without a node of known
/// gradient nearby.
std::vector<double> evenLengths(const FieldAlong& field);

}  // namespace lamina
