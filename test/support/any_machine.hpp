// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A joint of a machine made up for a test.
struct MachinePart {
  std::string name;
  Point3 axis;
  Point3 place_m;
  Point3 rpy;
};

/// Joints x, y, z, a and b, in any order from the bed to the nozzle.
using MachineParts = std::vector<MachinePart>;

/// Axes, places and order by chance; the linear axes span space.
MachineParts anyParts(Random& random);

/// Description of the machine whose root carries the bed by the first `carrying_bed` joints.
std::string urdfOf(const MachineParts& parts, std::size_t carrying_bed = 0);

/// Description of a machine of any parts and any root.
std::string anyMachine(Random& random);

}  // namespace lamina
