// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/shell_propagation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lamina/base/parallel.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "lamina/slicing/conformal/facing_surface.hpp"
#include "slicing/curved/vertex_merging.hpp"

namespace lamina {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
// Field of vertices far from where the shell leaves the part [mm].
constexpr double kFar = 1.0;
// Times its length in the source: beyond it, a side of a triangle has grown so much that it is looked at.
constexpr double kGrown = 2.0;
constexpr double kJustOutside = 1e-9;
// How far outside the part a vertex may lie that slides along its surface [mm].
constexpr double kTouching = 1e-3;

/// Whether a triangle of a shell faces as its vertices' normals do.
bool facesForward(const Triangle& corner, const std::vector<Point3>& place,
                  const std::vector<VertexMotion>& motions) {
  const Point3 doubled = (place[corner[1]] - place[corner[0]]).cross(place[corner[2]] - place[corner[0]]);
  const Point3 forward = motions[corner[0]].normal + motions[corner[1]].normal + motions[corner[2]].normal;
  return doubled.dot(forward) > 0.0;
}

void turnOver(LayerSurface& shell) {
  shell.middle = turnedOver(std::move(shell.middle));
  for (Point3& normal : shell.normal) normal = -normal;
}

LayerSurface withinBound(const LayerSurface& shell, const ShellBound& bound) {
  std::vector<double> field;
  field.reserve(shell.middle.vertices.size());
  for (const Point3& vertex : shell.middle.vertices)
    field.push_back(bound.offset_mm - bound.normal.dot(vertex));
  const bool is_within = std::all_of(field.begin(), field.end(), [](double value) { return value >= 0.0; });
  return is_within ? shell : whereNotNegative(shell, field);
}

/// Cuts a shell where it leaves the part, given on which side its vertices are. Only near there the distance
/// to the part's surface is asked for.
LayerSurface insidePart(const LayerSurface& shell, const std::vector<char>& is_inside,
                        const ShellLimits& limits) {
  if (std::all_of(is_inside.begin(), is_inside.end(), [](char inside) { return inside != 0; })) return shell;
  std::vector<double> field(is_inside.size());
  std::vector<char> is_measured(is_inside.size(), 0);
  for (std::size_t i = 0; i < is_inside.size(); ++i) field[i] = is_inside[i] != 0 ? kFar : -kFar;
  for (const Triangle& corner : shell.middle.triangles) {
    const int inside = is_inside[corner[0]] + is_inside[corner[1]] + is_inside[corner[2]];
    if (inside == 0 || inside == 3) continue;
    for (const std::uint32_t vertex : corner) {
      if (is_measured[vertex] != 0) continue;
      is_measured[vertex] = 1;
      const double distance = std::abs(limits.allowed(shell.middle.vertices[vertex]));
      field[vertex] = is_inside[vertex] != 0 ? distance : -std::max(distance, kJustOutside);
    }
  }
  return whereNotNegative(shell, field);
}

}  // namespace

ShellPropagation::ShellPropagation(const ShellSource& source, double longest_edge_mm,
                                   const ShellLimits& limits, Progress& progress)
    : source_(source.surface),
      nearest_(source_),
      subdivision_(subdivide(source_, longest_edge_mm)),
      limits_(limits),
      motions_(vertexMotions(source, subdivision_, limits.bound)),
      reach_(vertexReach({surface(), motions_, nearest_}, limits, progress)),
      neighbours_(surface()) {}

double ShellPropagation::reachOf(std::uint32_t vertex) const {
  return std::min({reach_.collapse_mm[vertex], reach_.exit_mm[vertex], reach_.bound_mm[vertex]});
}

double ShellPropagation::farthest() const {
  double farthest = 0.0;
  for (std::uint32_t vertex = 0; vertex < surface().vertices.size(); ++vertex)
    farthest = std::max(farthest, reachOf(vertex));
  return farthest;
}

/// Offset up to which the layer is filled at a vertex.
double ShellPropagation::aheadOf(std::uint32_t vertex, const ShellAt& at) const {
  const double limit = std::min(reach_.exit_mm[vertex], reach_.bound_mm[vertex]);
  return std::max(at.offset_mm, std::min(at.offset_mm + 0.5 * at.height_mm, limit));
}

/// Whether a triangle is part of the shell: it faces forward, and where collapsed vertices were merged or its
/// sides have grown, samples of it lie at the offset from the source, not across what has collapsed.
bool ShellPropagation::isEquidistant(const Triangle& corner, const Triangle& root,
                                     const MergedVertices& merged, const ShellAt& at) const {
  if (!facesForward(root, merged.place, motions_)) return false;
  bool is_merged = false;
  bool has_grown = false;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    is_merged = is_merged || corner[k] != root[k] || merged.is_stopped[root[k]] != 0;
    const double before = (surface().vertices[corner[next]] - surface().vertices[corner[k]]).squaredNorm();
    const double after = (merged.place[root[next]] - merged.place[root[k]]).squaredNorm();
    has_grown = has_grown || after > kGrown * kGrown * before;
    longest = std::max(longest, std::sqrt(after));
  }
  const bool is_small = longest < 2.0 * at.height_mm;
  if (!is_merged && (!has_grown || is_small)) return true;
  const auto isAtOffset = [&](const Point3& sample) {
    const double far = at.offset_mm + (is_merged ? 0.5 : -0.5) * at.height_mm;
    const auto nearest = nearest_.nearest(sample, far);
    return is_merged ? nearest && nearest->distance_mm >= at.offset_mm - 0.5 * at.height_mm : !nearest;
  };
  const Point3& a = merged.place[root[0]];
  const Point3& b = merged.place[root[1]];
  const Point3& c = merged.place[root[2]];
  if (!isAtOffset((a + b + c) / 3.0)) return false;
  return is_small || (isAtOffset(0.5 * (a + b)) && isAtOffset(0.5 * (b + c)) && isAtOffset(0.5 * (c + a)));
}

ShellPropagation::Assembled ShellPropagation::assembled(const MergedVertices& merged,
                                                        const ShellAt& at) const {
  Assembled result;
  LayerSurface& shell = result.shell;
  std::vector<std::uint32_t> number(surface().vertices.size(), kNone);
  const double behind = at.offset_mm - 0.5 * at.height_mm;
  const auto vertexOf = [&](std::uint32_t root) {
    if (number[root] != kNone) return number[root];
    number[root] = static_cast<std::uint32_t>(result.origin.size());
    result.origin.push_back(root);
    const double ahead = aheadOf(root, at);
    const double tip = at.side == NozzleSide::Ahead ? ahead : behind;
    const VertexMotion& motion = motions_[root];
    const Point3 path = merged.is_stopped[root] != 0 ? motion.normal : motion.per_mm;
    shell.middle.vertices.push_back(merged.place[root]);
    shell.tip.emplace_back(merged.place[root] + (tip - at.offset_mm) * path);
    shell.normal.push_back(motion.normal);
    shell.height_mm.push_back(ahead - behind);
    return number[root];
  };
  for (const Triangle& corner : surface().triangles) {
    const Triangle root = {merged.root[corner[0]], merged.root[corner[1]], merged.root[corner[2]]};
    if (root[0] == MergedVertices::kGone || root[0] == root[1] || root[1] == root[2] || root[2] == root[0])
      continue;
    if (isEquidistant(corner, root, merged, at))
      shell.middle.triangles.push_back({vertexOf(root[0]), vertexOf(root[1]), vertexOf(root[2])});
  }
  return result;
}

LayerSurface ShellPropagation::shell(const ShellAt& at) const {
  const MergedVertices merged =
      mergeCollapsed({surface(), neighbours_, motions_, reach_.collapse_mm}, at.offset_mm);
  Assembled whole = assembled(merged, at);
  LayerSurface shell = std::move(whole.shell);
  if (limits_.part != nullptr) {
    std::vector<char> is_inside;
    is_inside.reserve(whole.origin.size());
    for (const std::uint32_t root : whole.origin) {
      const bool is_inside_part = merged.is_stopped[root] != 0
                                      ? limits_.allowed(merged.place[root]) >= -kTouching
                                      : reach_.exit_mm[root] > at.offset_mm;
      is_inside.push_back(is_inside_part ? 1 : 0);
    }
    shell = insidePart(shell, is_inside, limits_);
  }
  if (limits_.bound) shell = withinBound(shell, *limits_.bound);
  if (at.side == NozzleSide::Behind) turnOver(shell);
  return shell;
}

std::vector<LayerSurface> ShellPropagation::shells(double height_mm, NozzleSide side,
                                                   Progress& progress) const {
  const double count = std::max(0.0, std::ceil(farthest() / height_mm - 0.5));
  std::vector<LayerSurface> shells(static_cast<std::size_t>(count));
  const auto build = [&](std::size_t i) {
    shells[i] = shell({(static_cast<double>(i) + 0.5) * height_mm, height_mm, side});
  };
  parallelFor(shells.size(), build, progress, "propagate shells");
  const auto vanished = std::find_if(
      shells.begin(), shells.end(), [](const LayerSurface& shell) { return shell.middle.triangles.empty(); });
  shells.erase(vanished, shells.end());
  return shells;
}

// From the greatest reach down, vertices join the areas that hang together so far. Where two areas meet, the
// one of lesser reach ends if it stood out by more than a height.
std::vector<ShellEnd> ShellPropagation::ends(double height_mm) const {
  std::vector<std::uint32_t> order(surface().vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return reachOf(a) != reachOf(b) ? reachOf(a) > reachOf(b) : a < b;
  });
  std::vector<std::uint32_t> peak(order.size(), kNone);  // towards the vertex of greatest reach of its area
  const auto peakOf = [&peak](std::uint32_t vertex) {
    while (peak[vertex] != vertex) vertex = peak[vertex] = peak[peak[vertex]];
    return vertex;
  };
  std::vector<ShellEnd> ends;
  const auto isLower = [this](std::uint32_t a, std::uint32_t b) {
    return reachOf(a) != reachOf(b) ? reachOf(a) < reachOf(b) : a > b;
  };
  for (const std::uint32_t vertex : order) {
    peak[vertex] = vertex;
    for (const std::uint32_t next : neighbours_.of(vertex)) {
      if (peak[next] == kNone) continue;
      std::uint32_t here = peakOf(vertex);
      std::uint32_t there = peakOf(next);
      if (here == there) continue;
      if (isLower(there, here)) std::swap(here, there);
      if (reachOf(here) - reachOf(vertex) > height_mm)
        ends.push_back({reachOf(here), surface().vertices[here]});
      peak[here] = there;
    }
  }
  for (const std::uint32_t vertex : order)
    if (peak[vertex] == vertex) ends.push_back({reachOf(vertex), surface().vertices[vertex]});
  std::stable_sort(ends.begin(), ends.end(),
                   [](const ShellEnd& a, const ShellEnd& b) { return a.offset_mm > b.offset_mm; });
  return ends;
}

}  // namespace lamina
