// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lightning/branches.hpp"

#include "infill/lightning/branch_forest.hpp"

namespace lamina {

std::vector<std::vector<Polyline>> branchesUnderRoofs(const std::vector<BranchLayer>& layers,
                                                      const BranchSettings& settings, Progress& progress) {
  std::vector<std::vector<Polyline>> branches(layers.size());
  BranchForest forest;
  for (std::size_t done = 0; done < layers.size(); ++done) {
    throwIfCancelled(progress, "branches");
    progress.report("branches", static_cast<double>(done) / static_cast<double>(layers.size()));
    const BranchLayer& layer = layers[layers.size() - 1 - done];
    forest.descend(layer.inside, layer.reach_mm, settings.spacing_mm);
    forest.grow(layer.inside, layer.roof, settings.spacing_mm);
    branches[layers.size() - 1 - done] = forest.branches(settings.overrun_mm);
  }
  return branches;
}

}  // namespace lamina
