// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/octree_export.hpp"

#include <octomap/OcTree.h>

#include <sstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

std::shared_ptr<octomap::OcTree> octreeOf(const HeightMap& surface, double units_per_mm,
                                          const Eigen::Isometry3d& tree_from_map) {
  const HeightGrid& grid = surface.grid();
  auto tree = std::make_shared<octomap::OcTree>(grid.cell_mm * units_per_mm);
  const float occupied = tree->getClampingThresMaxLog();
  for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
    if (!surface.isKnown(cell)) continue;
    const Point2 centre = grid.centre(cell);
    const Point3 place = tree_from_map * Point3(centre.x(), centre.y(), surface.at(cell)) * units_per_mm;
    octomap::OcTreeKey key;
    if (!tree->coordToKeyChecked(place.x(), place.y(), place.z(), key))
      throw InvalidInput("height map reaches farther from the origin than an octree with leaves of " +
                         numberText(grid.cell_mm) + " mm, which ends at " +
                         numberText(32768.0 * grid.cell_mm) + " mm");
    tree->setNodeValue(key, occupied, true);
  }
  tree->updateInnerOccupancy();
  tree->prune();
  return tree;
}

void writeOctree(const std::string& path, const octomap::OcTree& tree) {
  std::ostringstream bytes;
  if (!tree.writeBinaryConst(bytes)) throw FileError("cannot write the octree " + path);
  AtomicFile file(path);
  file.write(bytes.str());
  file.commit();
}

}  // namespace lamina
