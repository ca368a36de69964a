// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/spiral.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/contour/contour_tree.hpp"
#include "infill/contour/joined_loop.hpp"
#include "infill/fill_seed.hpp"

namespace lamina {
namespace {

/// Places that are tried for the spiral to start.
constexpr int kTrials = 16;
/// Of a step to the next contour, in distances between them.
constexpr double kLongestStep = 1.6;
/// Part of a contour that a gap may take.
constexpr double kLargestGap = 0.4;

/// The outer rings from the largest contour inwards, at each node on to the largest inside it.
std::vector<std::size_t> mainRings(const ContourTree& tree, const RingNet& net) {
  std::vector<std::size_t> outer_ring(tree.parents.size(), tree.loops.size());
  for (std::size_t ring = tree.loops.size(); ring-- > 0;) outer_ring[tree.loops[ring].node] = ring;
  std::vector<std::size_t> chain;
  for (std::size_t node = 0;;) {
    std::size_t largest = 0;
    double length = 0.0;
    for (std::size_t child = node + 1; child < tree.parents.size(); ++child) {
      if (tree.parents[child] != node || outer_ring[child] == tree.loops.size()) continue;
      const double there = net.rings()[outer_ring[child]].length();
      if (there <= length) continue;
      length = there;
      largest = child;
    }
    if (largest == 0) return chain;
    chain.push_back(outer_ring[largest]);
    node = largest;
  }
}

class SpiralBuilder {
 public:
  SpiralBuilder(const RingNet& net, const InfillRequest& request)
      : net_(net), scale_(request.spacing_mm / request.pitch_mm) {}

  /// The gaps of a spiral that starts at a position of the first ring, as far in as it gets.
  std::vector<RingGap> gapsFrom(const std::vector<std::size_t>& rings, double position) const {
    std::vector<RingGap> gaps = {gapBefore(rings.front(), position)};
    std::vector<Step> steps;
    for (std::size_t i = 1; i < rings.size(); ++i) {
      const Ring& before = net_.rings()[rings[i - 1]];
      const Ring& ring = net_.rings()[rings[i]];
      const Point2 start = before.pointAt(gaps.back().from_mm);
      const RingPlace landing = ring.nearest(start);
      const double apart =
          0.5 * scale_ * (before.widthAt(gaps.back().from_mm) + ring.widthAt(landing.position_mm));
      const Step step = {start, ring.pointAt(landing.position_mm)};
      if (landing.distance_mm > kLongestStep * apart || isCrossed(step, steps)) break;
      steps.push_back(step);
      gaps.push_back(gapBefore(rings[i], landing.position_mm));
    }
    return gaps;
  }

 private:
  struct Step {
    Point2 from;
    Point2 to;
  };

  bool isCrossed(const Step& step, const std::vector<Step>& others) const {
    for (const Ring& ring : net_.rings())
      if (ring.isCrossedBy(step.from, step.to)) return true;
    return std::any_of(others.begin(), others.end(), [&](const Step& other) {
      return areCrossing(step.from, step.to, other.from, other.to);
    });
  }

  RingGap gapBefore(std::size_t index, double position) const {
    const Ring& ring = net_.rings()[index];
    const double length = std::min(scale_ * ring.widthAt(position), kLargestGap * ring.length());
    const double from = ring.wrapped(position - length);
    return {index, from, from + length};
  }

  const RingNet& net_;
  double scale_;
};

std::vector<FillPath> spiralOf(const Region& region, const InfillRequest& request, std::size_t index) {
  const ContourTree tree = contourTree(region, request);
  RingNet net = ringsOf(tree);
  const std::vector<std::size_t> rings = mainRings(tree, net);
  if (rings.empty()) return {};
  const SpiralBuilder builder(net, request);
  Random random = randomOf(request.settings.contour.seed, request, index);
  std::vector<RingGap> best;
  for (int i = 0; i < kTrials && best.size() < rings.size(); ++i) {
    std::vector<RingGap> gaps =
        builder.gapsFrom(rings, random.uniform(0.0, net.rings()[rings.front()].length()));
    if (gaps.size() > best.size()) best = std::move(gaps);
  }
  net.chain(best);
  joinRings(net, tree, request, index);
  return net.lines();
}

}  // namespace

std::vector<FillPath> spiral(const Regions& regions, const InfillRequest& request) {
  std::vector<FillPath> runs;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    std::vector<FillPath> lines = spiralOf(regions[i], request, i);
    std::move(lines.begin(), lines.end(), std::back_inserter(runs));
  }
  return runs;
}

}  // namespace lamina
