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

/// The outer loops from the largest contour inwards, at each node on to the largest inside it.
std::vector<std::size_t> mainLoops(const ContourTree& tree, const LoopGraph& net) {
  std::vector<std::size_t> outer_loop(tree.parents.size(), tree.loops.size());
  for (std::size_t loop = tree.loops.size(); loop-- > 0;) outer_loop[tree.loops[loop].node] = loop;
  std::vector<std::size_t> chain;
  for (std::size_t node = 0;;) {
    std::size_t largest = 0;
    double length = 0.0;
    for (std::size_t child = node + 1; child < tree.parents.size(); ++child) {
      if (tree.parents[child] != node || outer_loop[child] == tree.loops.size()) continue;
      const double there = net.loops()[outer_loop[child]].length();
      if (there <= length) continue;
      length = there;
      largest = child;
    }
    if (largest == 0) return chain;
    chain.push_back(outer_loop[largest]);
    node = largest;
  }
}

class SpiralBuilder {
 public:
  SpiralBuilder(const LoopGraph& net, const InfillRequest& request)
      : net_(net), scale_(request.spacing_mm / request.pitch_mm) {}

  /// The gaps of a spiral that starts at a position of the first loop, as far in as it gets.
  std::vector<LoopGap> gapsFrom(const std::vector<std::size_t>& loops, double position) const {
    std::vector<LoopGap> gaps = {gapBefore(loops.front(), position)};
    std::vector<Step> steps;
    for (std::size_t i = 1; i < loops.size(); ++i) {
      const Loop& before = net_.loops()[loops[i - 1]];
      const Loop& loop = net_.loops()[loops[i]];
      const Point2 start = before.pointAt(gaps.back().from_mm);
      const LoopPlace landing = loop.nearest(start);
      const double apart =
          0.5 * scale_ * (before.widthAt(gaps.back().from_mm) + loop.widthAt(landing.position_mm));
      const Step step = {start, loop.pointAt(landing.position_mm)};
      if (landing.distance_mm > kLongestStep * apart || isCrossed(step, steps)) break;
      steps.push_back(step);
      gaps.push_back(gapBefore(loops[i], landing.position_mm));
    }
    return gaps;
  }

 private:
  struct Step {
    Point2 from;
    Point2 to;
  };

  bool isCrossed(const Step& step, const std::vector<Step>& others) const {
    for (const Loop& loop : net_.loops())
      if (loop.isCrossedBy(step.from, step.to)) return true;
    return std::any_of(others.begin(), others.end(), [&](const Step& other) {
      return areCrossing(step.from, step.to, other.from, other.to);
    });
  }

  LoopGap gapBefore(std::size_t index, double position) const {
    const Loop& loop = net_.loops()[index];
    const double length = std::min(scale_ * loop.widthAt(position), kLargestGap * loop.length());
    const double from = loop.wrapped(position - length);
    return {index, from, from + length};
  }

  const LoopGraph& net_;
  double scale_;
};

std::vector<FillPath> spiralOf(const Region& region, const InfillRequest& request, std::size_t index) {
  const ContourTree tree = contourTree(region, request);
  LoopGraph net = loopsOf(tree);
  const std::vector<std::size_t> loops = mainLoops(tree, net);
  if (loops.empty()) return {};
  const SpiralBuilder builder(net, request);
  Random random = randomOf(request.settings.contour.seed, request, index);
  std::vector<LoopGap> best;
  for (int i = 0; i < kTrials && best.size() < loops.size(); ++i) {
    std::vector<LoopGap> gaps =
        builder.gapsFrom(loops, random.uniform(0.0, net.loops()[loops.front()].length()));
    if (gaps.size() > best.size()) best = std::move(gaps);
  }
  net.chain(best);
  joinLoops(net, tree, request, index);
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
