// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stiffness/rigid_motion.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace lamina {
namespace {

/// A node that rests, by its place on the lattice.
struct Rest {
  std::array<int, 3> at{};
  std::int32_t node = 0;
};

/// Nodes of the elements of a row that lie in the box of what is held.
void addRests(const ElementLattice& lattice, const ElementRun& run, const std::array<int, 2>& row,
              const HeldNodes& held, std::vector<Rest>& rests) {
  for (int corner = 0; corner < 4; ++corner) {
    const int j = row[0] + corner % 2;
    const int k = row[1] + corner / 2;
    if (j < held.low[1] || j > held.high[1] || k < held.low[2] || k > held.high[2]) continue;
    for (int i = std::max(run.begin, held.low[0]); i <= std::min(run.begin + run.count, held.high[0]); ++i)
      rests.push_back({{i, j, k}, lattice.nodeAt(i, j, k)});
  }
}

/// Per part, the nodes that the load keeps at rest.
std::vector<std::vector<Rest>> restsOf(const ElementLattice& lattice, const LoadCase& load,
                                       const ConnectedParts& parts) {
  std::vector<std::vector<Rest>> rests(parts.parts.size());
  for (int k = 0; k < lattice.count()[2]; ++k)
    for (int j = 0; j < lattice.count()[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run) {
        const auto number = static_cast<std::size_t>(run - lattice.elementsBegin(0));
        for (const HeldNodes& held : load.held)
          if (held.displacement_mm == 0.0)
            addRests(lattice, *run, {j, k}, held, rests[std::size_t(parts.part_of_run[number])]);
      }
    }
  return rests;
}

/// Holds the node nearest to the middle of those that rest, and against turning the one farthest from it
/// along the axis on which they lie farthest apart.
void holdAcross(const std::vector<Rest>& rests, std::size_t axis, GivenNodes& given) {
  std::array<double, 3> middle{};
  std::array<int, 3> low = rests.front().at;
  std::array<int, 3> high = low;
  for (const Rest& rest : rests)
    for (std::size_t a = 0; a < 3; ++a) {
      middle[a] += double(rest.at[a]) / double(rests.size());
      low[a] = std::min(low[a], rest.at[a]);
      high[a] = std::max(high[a], rest.at[a]);
    }
  const std::size_t one = (axis + 1) % 3;
  const std::size_t other = (axis + 2) % 3;
  const std::size_t wide = high[one] - low[one] >= high[other] - low[other] ? one : other;
  const std::size_t narrow = wide == one ? other : one;
  const auto distance = [&](const Rest& rest) {
    const double a = rest.at[wide] - middle[wide];
    const double b = rest.at[narrow] - middle[narrow];
    return std::make_tuple(a * a + b * b, rest.node);
  };
  const Rest& pin = *std::min_element(
      rests.begin(), rests.end(), [&](const Rest& a, const Rest& b) { return distance(a) < distance(b); });
  const auto reach = [&](const Rest& rest) {
    return std::make_tuple(-std::abs(rest.at[wide] - pin.at[wide]),
                           std::abs(rest.at[narrow] - pin.at[narrow]), rest.node);
  };
  const Rest& guide = *std::min_element(rests.begin(), rests.end(),
                                        [&](const Rest& a, const Rest& b) { return reach(a) < reach(b); });
  given[wide].push_back(pin.node);
  given[narrow].push_back(pin.node);
  given[narrow].push_back(guide.node);
}

}  // namespace

GivenNodes givenNodes(const ElementLattice& lattice, const LoadCase& load, const ConnectedParts& parts) {
  GivenNodes given;
  const auto axis = static_cast<std::size_t>(load.axis);
  for (const HeldNodes& held : load.held) {
    const std::vector<std::int32_t> nodes = nodesOf(lattice, held);
    given[axis].insert(given[axis].end(), nodes.begin(), nodes.end());
  }
  for (const std::vector<Rest>& rests : restsOf(lattice, load, parts)) holdAcross(rests, axis, given);
  for (auto& nodes : given) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  return given;
}

}  // namespace lamina
