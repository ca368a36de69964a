// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/joined_loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "infill/contour/loop_link.hpp"
#include "infill/fill_seed.hpp"

namespace lamina {
namespace {

/// Limits for links, strictest first; even the last ones are better than leaving a loop separate.
constexpr std::array<LinkLimits, 3> kLimits = {LinkLimits{}, LinkLimits{0.85, 1.4, 0.5, 1.7, 0.4},
                                               LinkLimits{0.5, 2.3, 0.2, 3.0, 0.1}};

/// Points that stand nearer together than this are one [mm].
constexpr double kSamePoint = 1e-6;

Loop loopOf(const ContourLoop& loop) {
  Polygon points;
  std::vector<double> width;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Point2& last = points.empty() ? loop.points.back() : points.back();
    if ((loop.points[i] - last).norm() < kSamePoint) continue;
    points.push_back(loop.points[i]);
    width.push_back(loop.width_mm[i]);
  }
  return Loop(std::move(points), std::move(width));
}

std::vector<Loop> bordersOf(const ContourTree& tree) {
  std::vector<Loop> borders;
  for (const Polygon& outline : tree.border)
    borders.push_back(loopOf({outline, std::vector<double>(outline.size(), 0.0), 0}));
  return borders;
}

class Joiner {
 public:
  Joiner(LoopGraph& net, const ContourTree& tree, const InfillRequest& request, std::size_t region)
      : net_(net),
        tree_(tree),
        settings_(request.settings.contour),
        scale_(request.spacing_mm / request.pitch_mm),
        random_(randomOf(settings_.seed, request, region)),
        loops_of_(tree.parents.size()),
        children_(tree.parents.size()) {
    for (std::size_t loop = 0; loop < tree.loops.size(); ++loop)
      loops_of_[tree.loops[loop].node].push_back(loop);
    for (std::size_t node = 1; node < tree.parents.size(); ++node)
      children_[tree.parents[node]].push_back(node);
  }

  void join() {
    const std::size_t count = net_.loops().size();
    groups_ = 0;
    for (std::size_t loop = 0; loop < count; ++loop) groups_ += net_.groupOf(loop) == loop ? 1 : 0;
    for (const LinkLimits& limits : kLimits) {
      if (groups_ > 1 && &limits != &kLimits.front() && borders_.empty()) borders_ = bordersOf(tree_);
      // From the innermost out, each first to its parent.
      for (std::size_t loop = count; loop-- > 0 && groups_ > 1;)
        joinToOthers(loop, outerNeighbours(loop), limits);
      for (bool has_joined = true; has_joined && groups_ > 1;) {
        has_joined = false;
        for (std::size_t loop = count; loop-- > 0 && groups_ > 1;)
          has_joined = joinToOthers(loop, allNeighbours(loop), limits) || has_joined;
      }
    }
  }

 private:
  std::vector<std::size_t> outerNeighbours(std::size_t loop) const {
    return loops_of_[tree_.parents[tree_.loops[loop].node]];
  }

  std::vector<std::size_t> allNeighbours(std::size_t loop) const {
    const std::size_t node = tree_.loops[loop].node;
    const std::size_t parent = tree_.parents[node];
    std::vector<std::size_t> all;
    const auto add = [&](std::size_t of) {
      for (const std::size_t other : loops_of_[of])
        if (other != loop) all.push_back(other);
    };
    add(parent);
    for (const std::size_t sibling : children_[parent]) add(sibling);
    for (const std::size_t child : children_[node]) add(child);
    return all;
  }

  /// Where the loop is to be cut first.
  double firstPlace(const Loop& loop) { return random_.uniform(0.0, loop.length()); }

  bool joinToOthers(std::size_t loop, std::vector<std::size_t> others, const LinkLimits& limits) {
    const std::size_t group = net_.groupOf(loop);
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](std::size_t other) { return net_.groupOf(other) == group; }),
                 others.end());
    if (others.empty()) return false;
    const Loop& line = net_.loops()[loop];
    const double first = firstPlace(line);
    const double step = 0.5 * distance(line, first, line, first);
    const int trials = std::max(8, static_cast<int>(std::ceil(line.length() / step)));
    for (int i = 0; i < trials; ++i) {
      const double position = first + line.length() * i / trials;
      if (std::optional<LoopLink> link = bestLink(loop, position, others, limits)) {
        net_.join(link->a, link->b, link->ends);
        --groups_;
        return true;
      }
    }
    return false;
  }

  bool crossesOthers(const LoopLink& link, const LinkLimits& limits) const {
    const std::array<Point2, 2> from = endsOf(link.a);
    std::array<Point2, 2> onto = endsOf(link.b);
    if (link.ends == LinkEnds::Opposite) std::swap(onto[0], onto[1]);
    for (const int side : {0, 1}) {
      if (net_.isLinkCrossedBy(from[side], onto[side])) return true;
      // Short links between loops that are neighbours have no other loop to cross.
      if (&limits == &kLimits.front()) continue;
      for (const std::vector<Loop>* lines : {&net_.loops(), &borders_})
        for (const Loop& line : *lines)
          if (line.isCrossedBy(from[side], onto[side])) return true;
    }
    return false;
  }

  std::array<Point2, 2> endsOf(const LoopGap& gap) const {
    const Loop& loop = net_.loops()[gap.loop];
    return {loop.pointAt(gap.from_mm), loop.pointAt(gap.to_mm)};
  }

  ContourLink otherKind() const {
    return settings_.link == ContourLink::Average ? ContourLink::Tangential : ContourLink::Average;
  }

  double distance(const Loop& a, double at_a, const Loop& b, double at_b) const {
    return 0.5 * scale_ * (a.widthAt(at_a) + b.widthAt(at_b));
  }

  std::optional<LoopLink> bestLink(std::size_t loop, double position, const std::vector<std::size_t>& others,
                                   const LinkLimits& limits) const {
    const Loop& line = net_.loops()[loop];
    const Point2 start = line.pointAt(position);
    const double reach = limits.longest * 1.5 * distance(line, position, line, position);
    std::optional<std::size_t> onto;
    LoopPlace nearest{0.0, reach};
    for (const std::size_t other : others) {
      const Box2& box = net_.loops()[other].box();
      if ((start.array() < box.low.array() - reach).any() || (start.array() > box.high.array() + reach).any())
        continue;
      const LoopPlace place = net_.loops()[other].nearest(start);
      if (place.distance_mm >= nearest.distance_mm) continue;
      nearest = place;
      onto = other;
    }
    if (!onto) return std::nullopt;
    const double apart = distance(line, position, net_.loops()[*onto], nearest.position_mm);
    const LinkTrial trial{loop, position, *onto, apart};
    std::optional<LoopLink> link = linkAt(net_, trial, settings_.link, limits);
    if (!link && &limits == &kLimits.back()) link = linkAt(net_, trial, otherKind(), limits);
    if (link && crossesOthers(*link, limits)) link.reset();
    return link;
  }

  LoopGraph& net_;
  const ContourTree& tree_;
  const ContourSettings& settings_;
  double scale_;
  Random random_;
  std::vector<Loop> borders_;                       ///< once links are tried that may reach across a hole
  std::vector<std::vector<std::size_t>> loops_of_;  ///< of each node
  std::vector<std::vector<std::size_t>> children_;  ///< of each node
  std::size_t groups_ = 0;
};

}  // namespace

LoopGraph loopsOf(const ContourTree& tree) {
  std::vector<Loop> loops;
  loops.reserve(tree.loops.size());
  for (const ContourLoop& loop : tree.loops) loops.push_back(loopOf(loop));
  return LoopGraph(std::move(loops));
}

void joinLoops(LoopGraph& net, const ContourTree& tree, const InfillRequest& request, std::size_t region) {
  Joiner(net, tree, request, region).join();
}

}  // namespace lamina
