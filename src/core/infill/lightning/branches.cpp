// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/lightning/branches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/spatial/edge_bands.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

/// Branches of one layer as trees whose roots stand at the walls.
class BranchForest {
 public:
  /// Makes the branches of the layer above those of the layer below it: see `branchesUnderRoofs`.
  /// @param inside  of the layer below
  void descend(const Regions& inside, double reach_mm, double spacing_mm);

  /// Adds tips until no place of the roof is farther than half the spacing from a branch or a wall.
  void grow(const Regions& inside, const Regions& roof, double spacing_mm);

  /// Each branch from its tip to its root, or to the branch it joins; roots prolonged by the overrun.
  std::vector<Polyline> branches(double overrun_mm) const;

 private:
  static constexpr int kWall = -1;

  struct Node {
    Point2 at;
    int parent = kWall;  ///< a root has none
    bool is_gone = false;
  };

  /// A place that a tip can be joined to.
  struct Hold {
    int node = kWall;  ///< at the tip's end of the branch it lies on; none on a wall
  };

  std::vector<int> childCounts() const;
  void shorten(double reach_mm);
  /// @param counts  of children that nodes had before they were shortened
  void straighten(double reach_mm, const std::vector<int>& counts);
  void cutOff(const Regions& inside, double spacing_mm);
  void reachWalls(const EdgeBands& edges, const PointGrid& walls);
  void compact();
  void addHolds(PointGrid& grid, std::vector<Hold>& holds, int node, double step_mm) const;
  int joint(const Hold& hold, const Point2& at);

  std::vector<Node> nodes_;
};

constexpr double kNoDistance = 1e-6;  // mm: the same place
constexpr double kHoldStep = 0.25;    // spacings between places that tips can be joined to
constexpr double kSampleStep = 0.35;  // spacings between places of a roof that are looked at

std::size_t index(int node) { return static_cast<std::size_t>(node); }

/// Points along outlines, no farther apart than the step.
PointGrid wallPoints(const Regions& inside, double step_mm) {
  const std::vector<Polygon> borders = outlines(inside);
  PointGrid grid(boundingBox(borders), 2.0 * step_mm);
  for (const Polygon& border : borders)
    for (std::size_t i = 0; i < border.size(); ++i) {
      const Point2& from = border[i];
      const Point2& to = border[(i + 1) % border.size()];
      const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step_mm)));
      for (int k = 0; k < pieces; ++k) grid.insert(from + (to - from) * k / pieces);
    }
  return grid;
}

/// Places of a roof on a grid that is the same in all layers.
std::vector<Point2> samplesOf(const Regions& roof, double step_mm) {
  std::vector<Point2> samples;
  const EdgeBands edges(roof);
  if (edges.box().isEmpty()) return samples;
  for (double k = std::ceil(edges.box().low.y() / step_mm); k * step_mm <= edges.box().high.y(); ++k) {
    const std::vector<double> crossings = edges.crossings(k * step_mm);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      for (double m = std::ceil(crossings[i] / step_mm); m * step_mm <= crossings[i + 1]; ++m)
        samples.emplace_back(m * step_mm, k * step_mm);
  }
  return samples;
}

double distanceTo(const PointGrid& grid, const Point2& place) {
  const auto nearest = grid.nearest(place, kNoDistance);
  return nearest ? (grid.points()[*nearest] - place).norm() : std::numeric_limits<double>::infinity();
}

std::vector<int> BranchForest::childCounts() const {
  std::vector<int> counts(nodes_.size(), 0);
  for (const Node& node : nodes_)
    if (!node.is_gone && node.parent != kWall) ++counts[index(node.parent)];
  return counts;
}

void BranchForest::shorten(double reach_mm) {
  std::vector<int> counts = childCounts();
  std::vector<double> allowance_mm(nodes_.size(), reach_mm);
  const std::size_t before = nodes_.size();
  for (std::size_t tip = 0; tip < before; ++tip) {
    if (nodes_[tip].is_gone || counts[tip] > 0) continue;
    double left_mm = reach_mm;
    std::size_t at = tip;
    while (true) {
      Node& node = nodes_[at];
      if (node.parent == kWall) {
        node.is_gone = true;
        break;
      }
      const std::size_t parent = index(node.parent);
      const double length = (nodes_[parent].at - node.at).norm();
      if (length > left_mm) {
        node.at += (nodes_[parent].at - node.at) * (left_mm / length);
        break;
      }
      left_mm -= length;
      node.is_gone = true;
      // A joint holds the tips of all branches that have gone as far as it.
      allowance_mm[parent] = std::min(allowance_mm[parent], left_mm);
      if (--counts[parent] > 0) break;
      left_mm = allowance_mm[parent];
      at = parent;
    }
    // A tip that was cut back into a node looked at before is not to be cut again.
    counts[at] = 1;
  }
}

void BranchForest::straighten(double reach_mm, const std::vector<int>& counts) {
  std::vector<int> only_child(nodes_.size(), kWall);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].is_gone && nodes_[i].parent != kWall)
      only_child[index(nodes_[i].parent)] = static_cast<int>(i);
  std::vector<Point2> moved;
  moved.reserve(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    moved.push_back(node.at);
    if (node.is_gone || node.parent == kWall || counts[i] != 1 || only_child[i] == kWall) continue;
    const Point2 middle = 0.5 * (nodes_[index(node.parent)].at + nodes_[index(only_child[i])].at);
    const double distance = (middle - node.at).norm();
    if (distance > kNoDistance) moved[i] += (middle - node.at) * std::min(1.0, reach_mm / distance);
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i].at = moved[i];
}

/// Each stretch of a branch that lies inside is a branch of its own, from one end or wall to the other.
void BranchForest::cutOff(const Regions& inside, double spacing_mm) {
  const EdgeBands edges(inside);
  std::vector<Node> kept;
  std::vector<int> place(nodes_.size(), kWall);
  const auto nodeAt = [&](const Point2& at) {
    kept.push_back({at, kWall, false});
    return static_cast<int>(kept.size()) - 1;
  };
  const auto placeOf = [&](int node) {
    int& found = place[index(node)];
    if (found == kWall) found = nodeAt(nodes_[index(node)].at);
    return found;
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent == kWall) continue;
    const Point2 from = nodes_[i].at;
    const Point2 along = nodes_[index(nodes_[i].parent)].at - from;
    std::vector<double> cuts = edges.cuts(from, from + along);
    cuts.push_back(1.0);
    double start = 0.0;
    for (const double end : cuts) {
      if (end > start && edges.enclose(from + 0.5 * (start + end) * along)) {
        const int tip = start == 0.0 ? placeOf(static_cast<int>(i)) : nodeAt(from + start * along);
        const int root = end == 1.0 ? placeOf(nodes_[i].parent) : nodeAt(from + end * along);
        kept[index(tip)].parent = root;
      }
      start = end;
    }
  }
  nodes_ = std::move(kept);
  reachWalls(edges, wallPoints(inside, kHoldStep * spacing_mm));
}

/// Roots stand at a wall again.
void BranchForest::reachWalls(const EdgeBands& edges, const PointGrid& walls) {
  const double near_mm = kNoDistance * 10.0;
  const std::size_t before = nodes_.size();
  for (std::size_t i = 0; i < before; ++i) {
    if (nodes_[i].is_gone || nodes_[i].parent != kWall || !edges.enclose(nodes_[i].at)) continue;
    const auto nearest = walls.nearest(nodes_[i].at, kNoDistance);
    if (!nearest || (walls.points()[*nearest] - nodes_[i].at).norm() < near_mm) continue;
    nodes_[i].parent = static_cast<int>(nodes_.size());
    nodes_.push_back({walls.points()[*nearest], kWall, false});
  }
}

void BranchForest::compact() {
  std::vector<int> place(nodes_.size(), kWall);
  std::vector<Node> kept;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].is_gone) continue;
    place[i] = static_cast<int>(kept.size());
    kept.push_back(nodes_[i]);
  }
  for (Node& node : kept)
    if (node.parent != kWall) node.parent = place[index(node.parent)];
  nodes_ = std::move(kept);
}

void BranchForest::descend(const Regions& inside, double reach_mm, double spacing_mm) {
  if (nodes_.empty()) return;
  cutOff(inside, spacing_mm);
  // A joint whose other branch has just gone still holds that branch's tip: it stays where it is.
  const std::vector<int> counts = childCounts();
  shorten(reach_mm);
  straighten(reach_mm, counts);
  compact();
}

void BranchForest::addHolds(PointGrid& grid, std::vector<Hold>& holds, int node, double step_mm) const {
  const Node& tip = nodes_[index(node)];
  if (tip.parent == kWall) return;
  const Point2 along = nodes_[index(tip.parent)].at - tip.at;
  const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / step_mm)));
  for (int k = 0; k < pieces; ++k) {
    grid.insert(tip.at + along * k / pieces);
    holds.push_back({node});
  }
}

/// The node at a place that tips are joined to; the branch there may have been divided since.
int BranchForest::joint(const Hold& hold, const Point2& at) {
  if (hold.node == kWall) {
    nodes_.push_back({at, kWall, false});
    return static_cast<int>(nodes_.size()) - 1;
  }
  const Point2 from = nodes_[index(hold.node)].at;
  const double distance = (at - from).norm();
  int node = hold.node;
  while (distance > kNoDistance && nodes_[index(node)].parent != kWall) {
    const int parent = nodes_[index(node)].parent;
    const double to_parent = (nodes_[index(parent)].at - from).norm();
    if (to_parent > distance + kNoDistance) {
      const int between = static_cast<int>(nodes_.size());
      nodes_.push_back({at, parent, false});
      nodes_[index(node)].parent = between;
      return between;
    }
    node = parent;
    if (to_parent > distance - kNoDistance) break;
  }
  return node;
}

void BranchForest::grow(const Regions& inside, const Regions& roof, double spacing_mm) {
  if (roof.empty()) return;
  const double step_mm = kHoldStep * spacing_mm;
  const double held_mm = 0.5 * spacing_mm;
  PointGrid grid = wallPoints(inside, step_mm);
  std::vector<Hold> holds(grid.points().size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) addHolds(grid, holds, static_cast<int>(i), step_mm);
  std::vector<std::pair<double, Point2>> open;
  for (const Point2& sample : samplesOf(roof, kSampleStep * spacing_mm)) {
    const double distance = distanceTo(grid, sample);
    if (distance > held_mm) open.emplace_back(distance, sample);
  }
  std::stable_sort(open.begin(), open.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& candidate : open) {
    const auto nearest = grid.nearest(candidate.second, kNoDistance);
    if (!nearest || (grid.points()[*nearest] - candidate.second).norm() <= held_mm) continue;
    const int parent = joint(holds[*nearest], grid.points()[*nearest]);
    nodes_.push_back({candidate.second, parent, false});
    addHolds(grid, holds, static_cast<int>(nodes_.size()) - 1, step_mm);
  }
}

std::vector<Polyline> BranchForest::branches(double overrun_mm) const {
  std::vector<int> waiting = childCounts();
  std::vector<double> beyond(nodes_.size(), 0.0);  // length of the longest way to a tip
  std::vector<int> main_child(nodes_.size(), kWall);
  std::vector<std::size_t> ready;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (waiting[i] == 0) ready.push_back(i);
  const std::vector<std::size_t> tips = ready;
  for (std::size_t next = 0; next < ready.size(); ++next) {
    const std::size_t i = ready[next];
    if (nodes_[i].parent == kWall) continue;
    const std::size_t parent = index(nodes_[i].parent);
    const double length = beyond[i] + (nodes_[parent].at - nodes_[i].at).norm();
    if (main_child[parent] == kWall || length > beyond[parent]) {
      beyond[parent] = length;
      main_child[parent] = static_cast<int>(i);
    }
    if (--waiting[parent] == 0) ready.push_back(parent);
  }
  std::vector<Polyline> found;
  for (const std::size_t tip : tips) {
    Polyline branch{nodes_[tip].at};
    std::size_t i = tip;
    while (nodes_[i].parent != kWall) {
      const std::size_t parent = index(nodes_[i].parent);
      branch.push_back(nodes_[parent].at);
      if (main_child[parent] != static_cast<int>(i)) break;
      i = parent;
    }
    if (branch.size() < 2) continue;
    const Point2 along = branch.back() - branch[branch.size() - 2];
    if (nodes_[i].parent == kWall && along.norm() > kNoDistance)
      branch.back() += along.normalized() * overrun_mm;
    found.push_back(std::move(branch));
  }
  return found;
}

}  // namespace

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
