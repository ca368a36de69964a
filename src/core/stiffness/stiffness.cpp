// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/stiffness/stiffness_memory.hpp"
#include "stiffness/conjugate_gradients.hpp"
#include "stiffness/connected_parts.hpp"
#include "stiffness/matrix_free_operator.hpp"
#include "stiffness/rigid_motion.hpp"
#include "stiffness/stress_recovery.hpp"

namespace lamina {
namespace {

void validate(StiffnessSettings settings) {
  SettingsSchema schema;
  describe(schema, settings);
  schema.validate();
}

std::string missesOf(const ConnectedPart& part, const std::vector<HeldNodes>& held) {
  std::string misses;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (!part.reaches[i]) misses += (misses.empty() ? "" : ", ") + held[i].name;
  return misses;
}

Box3 boxOf(const ConnectedPart& part, const ElementModel& model) {
  Box3 box;
  for (const auto& corner : {part.low, part.high})
    box.include(model.corner + model.element_mm * Point3(corner[0], corner[1], corner[2]));
  return box;
}

/// Leaves out what does not reach all that is held, and reports it.
std::vector<DroppedPart> dropIdleParts(ElementModel& model) {
  const ConnectedParts connected = connectedParts(model.lattice, model.load.held);
  std::vector<DroppedPart> dropped;
  for (const ConnectedPart& part : connected.parts)
    if (!part.reachesAll())
      dropped.push_back({part.elements, boxOf(part, model), missesOf(part, model.load.held)});
  if (dropped.size() == connected.parts.size())
    throw InvalidInput("no part of the solid reaches all that holds and presses; the largest box of " +
                       std::to_string(connected.parts.size()) + " parts misses: " + dropped.front().misses);
  if (dropped.empty()) return dropped;
  std::vector<bool> is_kept;
  for (const std::int32_t part : connected.part_of_run)
    is_kept.push_back(connected.parts[static_cast<std::size_t>(part)].reachesAll());
  model.lattice = model.lattice.withRuns(is_kept);
  return dropped;
}

ElementModel modelOf(const VoxelGrid& grid, const StiffnessSettings& settings) {
  const VoxelRange range = grid.solidRange();
  if (range.isEmpty()) throw InvalidInput("no voxel is solid; one at least must be");
  const VoxelFrame& frame = grid.frame();
  // Nodes are not counted yet; there is about one for each element at least.
  const auto solid = static_cast<double>(grid.solidCount());
  requireMemory(stiffnessBytes(solid, solid), settings.memory_mb, frame.voxel_mm);
  ElementLattice lattice(grid, range);
  requireMemory(stiffnessBytes(solid, lattice.nodeCount()), settings.memory_mb, frame.voxel_mm);
  LoadCase load = loadCase(lattice, frame.voxel_mm, settings);
  const Point3 corner = frame.corner + frame.voxel_mm * Point3(range.low[0], range.low[1], range.low[2]);
  return {std::move(lattice), corner, frame.voxel_mm, std::move(load)};
}

/// The given displacements along the axis of the load; 0 elsewhere.
NodeField<double> givenDisplacement(const ElementModel& model) {
  NodeField<double> displacement(model.lattice.nodeCount());
  auto& along = displacement.along[static_cast<std::size_t>(model.load.axis)];
  for (const HeldNodes& held : model.load.held)
    for (const std::int32_t node : nodesOf(model.lattice, held))
      along[static_cast<std::size_t>(node)] = held.displacement_mm;
  return displacement;
}

void addReactions(const ElasticMaterial& material, StiffnessResult& result) {
  const ElementModel& model = result.model;
  NodeField<double> force(model.lattice.nodeCount());
  addForces<double>({model.lattice, material, model.element_mm}, 1.0, result.displacement, force);
  const auto& along = force.along[static_cast<std::size_t>(model.load.axis)];
  double moved = 0.0;
  for (const HeldNodes& held : model.load.held)
    for (const std::int32_t node : nodesOf(model.lattice, held))
      (held.displacement_mm == 0.0 ? result.force_n : moved) += along[static_cast<std::size_t>(node)];
  result.imbalance_n = result.force_n + moved;
}

void findGreatestStress(StiffnessResult& result) {
  const ElementLattice& lattice = result.model.lattice;
  std::size_t at = 0;
  for (int k = 0; k < lattice.count()[2]; ++k)
    for (int j = 0; j < lattice.count()[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run)
        for (std::int32_t i = 0; i < run->count; ++i) {
          const float stress = result.stress[at++].vonMises();
          if (stress <= result.greatest_stress_mpa) continue;
          result.greatest_stress_mpa = stress;
          result.greatest_stress_at =
              result.model.corner + result.model.element_mm * Point3(run->begin + i + 0.5, j + 0.5, k + 0.5);
        }
    }
}

}  // namespace

StiffnessResult solveStiffness(const VoxelGrid& grid, const StiffnessSettings& settings, Progress& progress) {
  validate(settings);
  throwIfCancelled(progress, "solve");
  StiffnessResult result;
  result.model = modelOf(grid, settings);
  result.dropped = dropIdleParts(result.model);
  const ElementModel& model = result.model;
  result.given = givenNodes(model.lattice, model.load, connectedParts(model.lattice, model.load.held));
  result.displacement = givenDisplacement(model);
  const Iteration reached = balance({{model.lattice, settings.material, model.element_mm}, result.given},
                                    {settings.residual, settings.iterations}, result.displacement, progress);
  if (!(reached.residual <= settings.residual))
    throw InvalidInput("forces are balanced to " + std::to_string(reached.residual) + " after " +
                       std::to_string(reached.count) + " iterations; stiffness.residual asks for " +
                       std::to_string(settings.residual));
  result.iterations = reached.count;
  result.residual = reached.residual;
  addReactions(settings.material, result);
  result.modulus_mpa = equivalentModulus(model.load, settings.load, result.force_n);
  result.stress = stressOf(model.lattice, settings.material, model.element_mm, result.displacement);
  findGreatestStress(result);
  return result;
}

}  // namespace lamina
