// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/joined_loop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/spatial/box_tree.hpp"
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

/// Loops among which others are looked up: near a place, and whether any is not joined yet. In their order.
class LoopList {
 public:
  void add(std::size_t loop) { loops_.push_back(loop); }

  /// Whether a loop belongs to another group than this one. Groups only ever merge: the first loops that
  /// are known to be of one group stay so, and are not asked again.
  bool hasOtherThan(std::size_t group, const LoopGraph& net) {
    if (loops_.empty()) return false;
    const std::size_t first = net.groupOf(loops_.front());
    if (first != group) return true;
    while (alike_ < loops_.size() && net.groupOf(loops_[alike_]) == first) ++alike_;
    return alike_ < loops_.size();
  }

  /// Appends those whose boxes overlap a box.
  void appendNear(const Box2& box, const std::vector<Loop>& of, std::vector<std::size_t>& near) {
    if (loops_.empty()) return;
    if (!tree_) tree_.emplace(boxes(of));
    std::vector<std::uint32_t> found;
    tree_->visitOverlapping(raised(box), [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    for (const std::uint32_t i : found) near.push_back(loops_[i]);
  }

 private:
  static Box3 raised(const Box2& box) {
    return {{box.low.x(), box.low.y(), 0.0}, {box.high.x(), box.high.y(), 0.0}};
  }

  std::vector<Box3> boxes(const std::vector<Loop>& of) const {
    std::vector<Box3> all;
    all.reserve(loops_.size());
    for (const std::size_t loop : loops_) all.push_back(raised(of[loop].box()));
    return all;
  }

  std::vector<std::size_t> loops_;
  std::size_t alike_ = 0;
  std::optional<BoxTree> tree_;
};

class Joiner {
 public:
  Joiner(LoopGraph& net, const ContourTree& tree, const InfillRequest& request, std::size_t region)
      : net_(net),
        tree_(tree),
        settings_(request.settings.contour),
        scale_(request.spacing_mm / request.pitch_mm),
        random_(randomOf(settings_.seed, request, region)),
        loops_of_(tree.parents.size()),
        loops_below_(tree.parents.size()) {
    std::vector<std::vector<std::size_t>> of_node(tree.parents.size());
    for (std::size_t loop = 0; loop < tree.loops.size(); ++loop)
      of_node[tree.loops[loop].node].push_back(loop);
    for (std::size_t node = 0; node < of_node.size(); ++node)
      for (const std::size_t loop : of_node[node]) {
        loops_of_[node].add(loop);
        if (node > 0) loops_below_[tree.parents[node]].add(loop);
      }
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
  using Neighbours = std::vector<LoopList*>;

  Neighbours outerNeighbours(std::size_t loop) { return {&loops_of_[tree_.parents[tree_.loops[loop].node]]}; }

  Neighbours allNeighbours(std::size_t loop) {
    const std::size_t node = tree_.loops[loop].node;
    const std::size_t parent = tree_.parents[node];
    return {&loops_of_[parent], &loops_below_[parent], &loops_below_[node]};
  }

  /// Those of other groups that a link from the loop can reach.
  std::vector<std::size_t> withinReach(std::size_t loop, const Neighbours& neighbours,
                                       const LinkLimits& limits) const {
    const Loop& line = net_.loops()[loop];
    double widest = 0.0;
    for (std::size_t edge = 0; edge < line.size(); ++edge) widest = std::max(widest, line.edgeWidth(edge));
    // A little more, as rounding may take a link that just reaches.
    const double reach = reachOf(scale_ * widest, limits) * (1.0 + kSamePoint) + kSamePoint;
    const Box2 box{line.box().low - Point2(reach, reach), line.box().high + Point2(reach, reach)};
    std::vector<std::size_t> near;
    for (LoopList* list : neighbours) list->appendNear(box, net_.loops(), near);
    const std::size_t group = net_.groupOf(loop);
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](std::size_t other) { return net_.groupOf(other) == group; }),
               near.end());
    return near;
  }

  static double reachOf(double apart, const LinkLimits& limits) { return limits.longest * 1.5 * apart; }

  /// Where the loop is to be cut first.
  double firstPlace(const Loop& loop) { return random_.uniform(0.0, loop.length()); }

  bool joinToOthers(std::size_t loop, const Neighbours& neighbours, const LinkLimits& limits) {
    const std::size_t group = net_.groupOf(loop);
    if (std::none_of(neighbours.begin(), neighbours.end(),
                     [&](LoopList* list) { return list->hasOtherThan(group, net_); }))
      return false;
    const Loop& line = net_.loops()[loop];
    // Drawn for loops without any in reach too, so that what follows does not depend on how they are found.
    const double first = firstPlace(line);
    const std::vector<std::size_t> others = withinReach(loop, neighbours, limits);
    if (others.empty()) return false;
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
    const double reach = reachOf(distance(line, position, line, position), limits);
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
  std::vector<Loop> borders_;          ///< once links are tried that may reach across a hole
  std::vector<LoopList> loops_of_;     ///< of each node
  std::vector<LoopList> loops_below_;  ///< of each node's children
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
