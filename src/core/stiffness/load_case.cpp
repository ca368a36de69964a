// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/load_case.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/stiffness/equivalent_modulus.hpp"

namespace lamina {
namespace {

/// All nodes of one plane.
HeldNodes plane(const ElementLattice& lattice, std::size_t axis, int at, const std::string& name) {
  HeldNodes held{name, {0, 0, 0}, lattice.count(), 0.0};
  held.low[axis] = at;
  held.high[axis] = at;
  return held;
}

LoadCase compression(const ElementLattice& lattice, double element_mm, const StiffnessSettings& settings) {
  const auto axis = static_cast<std::size_t>(settings.axis);
  const std::array<int, 3>& count = lattice.count();
  LoadCase load;
  load.axis = settings.axis;
  load.displacement_mm = settings.compression_mm;
  load.length_mm = element_mm * count[axis];
  load.area_mm2 = settings.area_mm2 > 0.0
                      ? settings.area_mm2
                      : element_mm * count[(axis + 1) % 3] * element_mm * count[(axis + 2) % 3];
  load.held = {plane(lattice, axis, 0, "base"), plane(lattice, axis, count[axis], "top")};
  load.held[1].displacement_mm = -settings.compression_mm;
  return load;
}

LoadCase bending(const ElementLattice& lattice, double element_mm, const StiffnessSettings& settings) {
  const auto axis = static_cast<std::size_t>(settings.axis);
  const std::array<int, 3>& count = lattice.count();
  const std::size_t one = (axis + 1) % 3;
  const std::size_t other = (axis + 2) % 3;
  const std::size_t along =
      count[one] > count[other] || (count[one] == count[other] && one < other) ? one : other;
  const std::size_t across = along == one ? other : one;
  const int middle = count[along] / 2;
  const int half = static_cast<int>(std::lround(0.5 * settings.span_mm / element_mm));
  if (half < 1 || half > middle || middle + half > count[along])
    throw InvalidConfig("stiffness.span_mm is " + numberText(settings.span_mm) + " mm; must be from " +
                        numberText(2.0 * element_mm) + " mm to the " + numberText(2.0 * middle * element_mm) +
                        " mm of the part along " + std::string(1, "xyz"[along]));
  LoadCase load;
  load.axis = settings.axis;
  load.displacement_mm = settings.deflection_mm;
  load.length_mm = 2.0 * half * element_mm;
  load.width_mm = element_mm * count[across];
  load.height_mm = element_mm * count[axis];
  load.held = {plane(lattice, axis, 0, "first support"), plane(lattice, axis, 0, "second support"),
               plane(lattice, axis, count[axis], "punch")};
  const std::array<int, 3> places{middle - half, middle + half, middle};
  for (std::size_t i = 0; i < 3; ++i) load.held[i].low[along] = load.held[i].high[along] = places[i];
  load.held[2].displacement_mm = -settings.deflection_mm;
  return load;
}

}  // namespace

LoadCase loadCase(const ElementLattice& lattice, double element_mm, const StiffnessSettings& settings) {
  return settings.load == Load::Compression ? compression(lattice, element_mm, settings)
                                            : bending(lattice, element_mm, settings);
}

double equivalentModulus(const LoadCase& load, Load kind, double force_n) {
  return kind == Load::Compression
             ? compressionModulus(force_n, load.length_mm, load.area_mm2, load.displacement_mm)
             : bendingModulus(force_n, load.length_mm, load.displacement_mm, {load.width_mm, load.height_mm});
}

std::vector<std::int32_t> nodesOf(const ElementLattice& lattice, const HeldNodes& held) {
  std::vector<std::int32_t> nodes;
  for (int k = held.low[2]; k <= held.high[2]; ++k)
    for (int j = held.low[1]; j <= held.high[1]; ++j) {
      const int row = lattice.nodeRow(j, k);
      for (const NodeSpan* run = lattice.nodesBegin(row); run != lattice.nodesEnd(row); ++run)
        for (int i = std::max(run->begin, held.low[0]); i < std::min(run->end(), held.high[0] + 1); ++i)
          nodes.push_back(run->node + (i - run->begin));
    }
  return nodes;
}

}  // namespace lamina
