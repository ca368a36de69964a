// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/lift/bead_bounds.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace lamina {
namespace {

/// What rounding adds to a motion that is exactly full.
constexpr double kBoundRounding = 1e-9;

class LoadSpreading {
 public:
  LoadSpreading(const std::vector<MotionLoad>& motions, const LoadLimits& limits)
      : motions_(motions), limits_(limits) {
    bounded_.mm3.reserve(motions.size());
    for (const MotionLoad& motion : motions) bounded_.mm3.push_back(motion.mm3);
  }

  BoundedLoads spread() && {
    for (std::size_t i = 0; i < motions_.size(); ++i)
      if (isTooMuch(bounded_.mm3[i], motions_[i].usual_mm3)) share(groupAround(i));
    return std::move(bounded_);
  }

 private:
  /// Motions next to each other, in a closed run also across its start.
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;
    MotionLoad sum;
    std::size_t last_added = 0;
    double share_of_last = 1.0;  // that lies within the reach
  };

  bool isTooMuch(double mm3, double usual_mm3) const {
    return mm3 > limits_.fullest * usual_mm3 * (1.0 + kBoundRounding);
  }

  std::size_t wrapped(std::size_t index) const { return index % motions_.size(); }

  void add(Group& group, std::size_t motion) const {
    const double length = motions_[motion].length_mm;
    const double left = std::max(0.0, limits_.reach_mm - group.sum.length_mm);
    group.share_of_last = group.count > 0 && length > left ? left / length : 1.0;
    group.last_added = motion;
    ++group.count;
    group.sum.mm3 += group.share_of_last * bounded_.mm3[motion];
    group.sum.usual_mm3 += group.share_of_last * motions_[motion].usual_mm3;
    group.sum.length_mm += length;
  }

  Group groupAround(std::size_t motion) const {
    const std::size_t all = motions_.size();
    Group group;
    group.first = motion;
    add(group, motion);
    bool is_forward = true;
    while (isTooMuch(group.sum.mm3, group.sum.usual_mm3) && group.sum.length_mm < limits_.reach_mm &&
           group.count < all) {
      const bool has_next = limits_.is_closed || group.first + group.count < all;
      const bool has_previous = limits_.is_closed || group.first > 0;
      if (has_next && (is_forward || !has_previous)) {
        add(group, wrapped(group.first + group.count));
      } else {
        group.first = wrapped(group.first + all - 1);
        add(group, group.first);
      }
      is_forward = !is_forward;
    }
    return group;
  }

  void share(const Group& group) {
    const double room = limits_.fullest * group.sum.usual_mm3;
    const double deposited = std::min(group.sum.mm3, room);
    const double fullness = room > 0.0 ? deposited / group.sum.usual_mm3 : 0.0;
    bounded_.left_out_mm3 += group.sum.mm3 - deposited;
    for (std::size_t k = 0; k < group.count; ++k) {
      const std::size_t motion = wrapped(group.first + k);
      const double part = motion == group.last_added ? group.share_of_last : 1.0;
      double& mm3 = bounded_.mm3[motion];
      mm3 = (1.0 - part) * mm3 + part * fullness * motions_[motion].usual_mm3;
    }
  }

  const std::vector<MotionLoad>& motions_;
  const LoadLimits& limits_;
  BoundedLoads bounded_;
};

}  // namespace

BoundedLoads boundLoads(const std::vector<MotionLoad>& motions, const LoadLimits& limits) {
  return LoadSpreading(motions, limits).spread();
}

}  // namespace lamina
