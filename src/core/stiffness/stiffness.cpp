// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "conjugate_gradients.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/stiffness/elastic_material.hpp"
#include "lamina/stiffness/element_lattice.hpp"
#include "lamina/stiffness/load_case.hpp"
#include "lamina/stiffness/node_field.hpp"
#include "lamina/stiffness/stiffness_memory.hpp"
#include "lamina/stiffness/stress.hpp"
#include "matrix_free_operator.hpp"

namespace lamina {
namespace {

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

/// Which things have become one.
class Union {
 public:
  explicit Union(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::int32_t root(std::int32_t of) {
    while (parent_[std::size_t(of)] != of) {
      parent_[std::size_t(of)] = parent_[std::size_t(parent_[std::size_t(of)])];
      of = parent_[std::size_t(of)];
    }
    return of;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> parent_;
};

/// Joins the runs of two rows that have a face in common.
void joinRows(const ElementLattice& lattice, int row, int other, Union& runs) {
  const ElementRun* const first = lattice.elementsBegin(0);
  const ElementRun* b = lattice.elementsBegin(other);
  for (const ElementRun* a = lattice.elementsBegin(row); a != lattice.elementsEnd(row); ++a) {
    while (b != lattice.elementsEnd(other) && b->begin + b->count <= a->begin) ++b;
    for (const ElementRun* c = b; c != lattice.elementsEnd(other) && c->begin < a->begin + a->count; ++c)
      runs.join(std::int32_t(a - first), std::int32_t(c - first));
  }
}

void joinPieces(const ElementLattice& lattice, int row, Union& runs) {
  const ElementRun* const first = lattice.elementsBegin(0);
  for (const ElementRun* a = lattice.elementsBegin(row); a != lattice.elementsEnd(row); ++a)
    if (a + 1 != lattice.elementsEnd(row) && a->begin + a->count == (a + 1)->begin)
      runs.join(std::int32_t(a - first), std::int32_t(a + 1 - first));
}

bool reaches(const std::array<int, 3>& low, const std::array<int, 3>& high, const HeldNodes& held) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (low[axis] > held.high[axis] || high[axis] < held.low[axis]) return false;
  return true;
}

void include(const std::array<int, 3>& low, const std::array<int, 3>& high,
             const std::vector<HeldNodes>& held, ConnectedPart& part) {
  if (part.elements == 0) {
    part.low = low;
    part.high = high;
    part.reaches.resize(held.size());
  }
  part.elements += high[0] - low[0];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    part.low[axis] = std::min(part.low[axis], low[axis]);
    part.high[axis] = std::max(part.high[axis], high[axis]);
  }
  for (std::size_t i = 0; i < held.size(); ++i)
    if (reaches(low, high, held[i])) part.reaches[i] = true;
}

Union joinedRuns(const ElementLattice& lattice) {
  const std::array<int, 3>& count = lattice.count();
  Union runs(lattice.runCount());
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      joinPieces(lattice, row, runs);
      if (j > 0) joinRows(lattice, row, lattice.elementRow(j - 1, k), runs);
      if (k > 0) joinRows(lattice, row, lattice.elementRow(j, k - 1), runs);
    }
  return runs;
}

bool ConnectedPart::reachesAll() const {
  return std::all_of(reaches.begin(), reaches.end(), [](bool is_reached) { return is_reached; });
}

ConnectedParts connectedParts(const ElementLattice& lattice, const std::vector<HeldNodes>& held) {
  Union runs = joinedRuns(lattice);
  ConnectedParts connected;
  std::vector<std::int32_t> part_of_root(lattice.runCount(), -1);
  const std::array<int, 3>& count = lattice.count();
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j) {
      const int row = lattice.elementRow(j, k);
      for (const ElementRun* run = lattice.elementsBegin(row); run != lattice.elementsEnd(row); ++run) {
        const auto number = static_cast<std::int32_t>(run - lattice.elementsBegin(0));
        std::int32_t& part = part_of_root[std::size_t(runs.root(number))];
        if (part < 0) {
          part = static_cast<std::int32_t>(connected.parts.size());
          connected.parts.emplace_back();
        }
        connected.part_of_run.push_back(part);
        include({run->begin, j, k}, {run->begin + run->count, j + 1, k + 1}, held,
                connected.parts[std::size_t(part)]);
      }
    }
  return connected;
}

/// Mean derivatives of the displacement over an element: column a is that along axis a, times four sides.
Eigen::Matrix3d fourGradients(const ElementRun& run, std::int32_t i, const NodeField<double>& displacement) {
  Eigen::Matrix3d gradients = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < 8; ++c) {
    const auto node = static_cast<std::size_t>(run.node[c / 2] + i) + c % 2;
    const Eigen::Vector3d u(displacement.along[0][node], displacement.along[1][node],
                            displacement.along[2][node]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      gradients.col(Eigen::Index(axis)) += (c >> axis & 1U) != 0 ? u : Eigen::Vector3d(-u);
  }
  return gradients;
}

Stress stressAt(const Eigen::Matrix3d& gradients, const ElasticMaterial& material) {
  const double pressure = material.lambda() * gradients.trace();
  const Eigen::Matrix3d stress =
      material.mu() * (gradients + gradients.transpose()) + pressure * Eigen::Matrix3d::Identity();
  return {float(stress(0, 0)), float(stress(1, 1)), float(stress(2, 2)),
          float(stress(0, 1)), float(stress(1, 2)), float(stress(2, 0))};
}

/// Stress in the middle of each element, in the order of the runs.
std::vector<Stress> stressOf(const ElementLattice& lattice, const ElasticMaterial& material,
                             double element_mm, const NodeField<double>& displacement) {
  std::vector<Stress> stress(static_cast<std::size_t>(lattice.elementCount()));
  parallelFor(lattice.runCount(), [&](std::size_t r) {
    const ElementRun& run = lattice.elementsBegin(0)[r];
    // A 0 stands after each run before it.
    const std::size_t first = std::size_t(run.column) - r;
    for (std::int32_t i = 0; i < run.count; ++i)
      stress[first + std::size_t(i)] =
          stressAt(fourGradients(run, i, displacement) / (4.0 * element_mm), material);
  });
  return stress;
}

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

/// The displacements that the load gives, and those that keep each part from sliding and turning across it:
/// of one resting node both components across, of another one. That much bears no force, so it
/// disturbs nothing.
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

float Stress::vonMises() const {
  const float normal = (xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx);
  return std::sqrt(0.5F * normal + 3.0F * (xy * xy + yz * yz + zx * zx));
}

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
    throw InvalidInput("forces are not in balance after " + std::to_string(reached.count) +
                       " iterations: unbalanced are " + numberText(reached.residual) +
                       " of those at the start; expected " + numberText(settings.residual) +
                       " (stiffness.residual) within " + std::to_string(settings.iterations) +
                       " (stiffness.iterations); smaller voxels need fewer");
  result.iterations = reached.count;
  result.residual = reached.residual;
  throwIfCancelled(progress, "solve");
  addReactions(settings.material, result);
  result.modulus_mpa = equivalentModulus(model.load, settings.load, result.force_n);
  throwIfCancelled(progress, "solve");
  result.stress = stressOf(model.lattice, settings.material, model.element_mm, result.displacement);
  findGreatestStress(result);
  return result;
}

}  // namespace lamina
