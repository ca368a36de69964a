// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/outline_links.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Ends are numbered 2 run for the first and 2 run + 1 for the last point of a run.
struct EndOnOutline {
  OutlinePoint place;
  std::size_t end = 0;
};

bool isBefore(const EndOnOutline& a, const EndOnOutline& b) {
  return std::tie(a.place.outline, a.place.edge, a.place.distance_mm, a.end) <
         std::tie(b.place.outline, b.place.edge, b.place.distance_mm, b.end);
}

/// Along the outline from one end to the next.
struct Link {
  std::size_t from = 0;  ///< index among the sorted ends
  std::size_t to = 0;
  double length_mm = 0.0;
};

/// Runs that hang together. What was joined last can be taken apart again.
class JoinedGroups {
 public:
  explicit JoinedGroups(std::size_t count) : parent_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// False if they hang together already.
  bool join(std::size_t a, std::size_t b) {
    a = rootOf(a);
    b = rootOf(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    joined_.push_back(b);
    return true;
  }

  void undoTo(std::size_t joints) {
    for (; joined_.size() > joints; joined_.pop_back()) {
      const std::size_t child = joined_.back();
      size_[parent_[child]] -= size_[child];
      parent_[child] = child;
    }
  }

 private:
  std::size_t rootOf(std::size_t run) const {
    while (parent_[run] != run) run = parent_[run];
    return run;
  }

  std::vector<std::size_t> parent_;
  std::vector<std::size_t> size_;
  std::vector<std::size_t> joined_;  ///< roots that got a parent, in order
};

class Joiner {
 public:
  Joiner(const std::vector<RunOnOutlines>& runs, const std::vector<Polygon>& outlines, double longest_mm,
         LinkChoice choice)
      : runs_(runs),
        outlines_(outlines),
        longest_mm_(longest_mm),
        joined_to_(2 * runs.size(), kNone),
        groups_(runs.size()) {
    sortEnds();
    std::vector<Link> links = candidates();
    if (choice == LinkChoice::EveryOther) makeEveryOther(links);
    makeShortestFirst(std::move(links));
  }

  std::vector<Polyline> join() {
    std::vector<Polyline> joined;
    is_done_.assign(runs_.size(), false);
    for (std::size_t end = 0; end < joined_to_.size(); ++end)
      if (joined_to_[end] == kNone && !is_done_[end / 2]) joined.push_back(trace(end));
    return joined;
  }

 private:
  void sortEnds() {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (runs_[run].first) ends_.push_back({*runs_[run].first, 2 * run});
      if (runs_[run].last) ends_.push_back({*runs_[run].last, 2 * run + 1});
    }
    std::sort(ends_.begin(), ends_.end(), isBefore);
  }

  const Point2& pointOf(std::size_t end) const {
    const Polyline& points = runs_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  std::size_t pointsBetween(const OutlinePoint& from, const OutlinePoint& to) const {
    const std::size_t size = outlines_[from.outline].size();
    if (to.edge == from.edge) return to.distance_mm >= from.distance_mm ? 0 : size;
    return to.edge > from.edge ? to.edge - from.edge : to.edge + size - from.edge;
  }

  const Point2& outlinePoint(const OutlinePoint& from, std::size_t step) const {
    const Polygon& outline = outlines_[from.outline];
    return outline[(from.edge + 1 + step) % outline.size()];
  }

  double lengthBetween(const EndOnOutline& from, const EndOnOutline& to) const {
    const std::size_t count = pointsBetween(from.place, to.place);
    Point2 at = pointOf(from.end);
    double sum = 0.0;
    for (std::size_t step = 0; step < count && sum <= longest_mm_; ++step) {
      sum += (outlinePoint(from.place, step) - at).norm();
      at = outlinePoint(from.place, step);
    }
    return sum + (pointOf(to.end) - at).norm();
  }

  /// Outline by outline, along each.
  std::vector<Link> candidates() const {
    std::vector<Link> links;
    for (std::size_t begin = 0, end = 0; begin < ends_.size(); begin = end) {
      while (end < ends_.size() && ends_[end].place.outline == ends_[begin].place.outline) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t next = i + 1 < end ? i + 1 : begin;
        const double length = lengthBetween(ends_[i], ends_[next]);
        if (next != i && length <= longest_mm_) links.push_back({i, next, length});
      }
    }
    return links;
  }

  bool make(const Link& link) {
    const std::size_t a = ends_[link.from].end;
    const std::size_t b = ends_[link.to].end;
    if (joined_to_[a] != kNone || joined_to_[b] != kNone || !groups_.join(a / 2, b / 2)) return false;
    joined_to_[a] = joined_to_[b] = links_.size();
    links_.push_back(link);
    return true;
  }

  void makeShortestFirst(std::vector<Link> links) {
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
      return a.length_mm != b.length_mm ? a.length_mm < b.length_mm : a.from < b.from;
    });
    for (const Link& link : links) make(link);
  }

  /// Chains of links, each of which begins where the one before ends.
  void makeEveryOther(const std::vector<Link>& links) {
    for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
      for (end = begin + 1; end < links.size() && links[end].from == links[end - 1].to;) ++end;
      const std::size_t before = links_.size();
      const std::size_t even = makeEverySecond(links, begin, end);
      undoTo(before);
      const std::size_t odd = makeEverySecond(links, begin + 1, end);
      if (odd >= even) continue;
      undoTo(before);
      makeEverySecond(links, begin, end);
    }
  }

  std::size_t makeEverySecond(const std::vector<Link>& links, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; i += 2)
      if (make(links[i])) ++count;
    return count;
  }

  void undoTo(std::size_t links) {
    for (; links_.size() > links; links_.pop_back())
      for (const std::size_t at : {links_.back().from, links_.back().to}) joined_to_[ends_[at].end] = kNone;
    groups_.undoTo(links);
  }

  /// From a free end to the other free end of the joined runs.
  Polyline trace(std::size_t end) {
    Polyline points;
    while (true) {
      appendRun(points, end);
      is_done_[end / 2] = true;
      const std::size_t far = end ^ 1U;
      if (joined_to_[far] == kNone) return points;
      const Link& link = links_[joined_to_[far]];
      const bool is_along = ends_[link.from].end == far;
      appendLink(points, link, is_along);
      end = is_along ? ends_[link.to].end : ends_[link.from].end;
    }
  }

  void appendRun(Polyline& points, std::size_t end) const {
    const Polyline& run = runs_[end / 2].points;
    if (end % 2 == 0)
      points.insert(points.end(), run.begin(), run.end());
    else
      points.insert(points.end(), run.rbegin(), run.rend());
  }

  void appendLink(Polyline& points, const Link& link, bool is_along) const {
    const OutlinePoint& from = ends_[link.from].place;
    const std::size_t count = pointsBetween(from, ends_[link.to].place);
    for (std::size_t step = 0; step < count; ++step)
      points.push_back(outlinePoint(from, is_along ? step : count - 1 - step));
  }

  const std::vector<RunOnOutlines>& runs_;
  const std::vector<Polygon>& outlines_;
  double longest_mm_;
  std::vector<EndOnOutline> ends_;  ///< along the outlines
  std::vector<Link> links_;
  std::vector<std::size_t> joined_to_;  ///< of each end, the link made there
  JoinedGroups groups_;                 ///< by as many joints as there are links
  std::vector<bool> is_done_;           ///< run by run
};

}  // namespace

std::vector<Polyline> joinAlongOutlines(const std::vector<RunOnOutlines>& runs,
                                        const std::vector<Polygon>& outlines, double longest_mm,
                                        LinkChoice choice) {
  return Joiner(runs, outlines, longest_mm, choice).join();
}

}  // namespace lamina
