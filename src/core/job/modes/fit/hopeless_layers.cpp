// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/hopeless_layers.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "planning/runs/cut_beads.hpp"

namespace lamina {
namespace {

constexpr std::size_t kTogether = 6;    // layers
constexpr std::size_t kMostGroups = 4;  // of layers: what these do not decide takes a check of the whole

/// The beads of some layers.
Toolpath beadsOf(const Toolpath& planned, const std::vector<LayerRange>& ranges) {
  Toolpath some;
  some.layers.resize(planned.layers.size());
  for (const LayerRange& range : ranges)
    for (std::size_t l = range.first; l < range.end; ++l) some.layers[l] = planned.layers[l];
  return some;
}

/// What was found on beads, but for singular places, where the nozzle may leave the bead to turn.
MachineCheck onBeads(MachineCheck check, const Toolpath& toolpath) {
  const auto isMended = [&](const Finding& finding) {
    return finding.what == toString(JointFault::Singular) ||
           toolpath.layers[finding.at.layer].paths[finding.at.path].role == PathRole::Travel;
  };
  for (std::vector<Finding>* findings : {&check.faults, &check.collisions})
    findings->erase(std::remove_if(findings->begin(), findings->end(), isMended), findings->end());
  return check;
}

HinderedWaypoints hinderedBeads(const MachineCheck& on_beads) {
  HinderedWaypoints hindered;
  for (const Finding& finding : on_beads.collisions) hindered.shut.insert(finding.at);
  for (const Finding& finding : on_beads.faults) hindered.shut.insert(finding.at);
  return hindered;
}

void append(std::vector<Finding> further, std::vector<Finding>& all) {
  std::move(further.begin(), further.end(), std::back_inserter(all));
}

/// Layers that are tried, a group at a time, none of them side by side.
class LayersTried {
 public:
  explicit LayersTried(std::size_t count) : is_tried_(count, 0), is_hindered_(count, 0) {}

  /// Layers evenly over the height.
  std::vector<LayerRange> spread() {
    const std::size_t step = std::max<std::size_t>(2, (is_tried_.size() + kTogether - 1) / kTogether);
    std::vector<LayerRange> ranges;
    ranges.reserve(kTogether);
    for (std::size_t l = 0; l < is_tried_.size(); l += step) ranges.push_back({l, l + 1});
    return tried(std::move(ranges));
  }

  /// The layers nearest to those in which something was found.
  std::vector<LayerRange> nearHindered() {
    std::vector<std::size_t> nearest;
    nearest.reserve(is_tried_.size());
    for (std::size_t l = 0; l < is_tried_.size(); ++l)
      if (is_tried_[l] == 0) nearest.push_back(l);
    const std::vector<std::size_t> way = wayToHindered();
    std::stable_sort(nearest.begin(), nearest.end(),
                     [&](std::size_t a, std::size_t b) { return way[a] < way[b]; });
    std::vector<LayerRange> ranges;
    ranges.reserve(kTogether);
    for (const std::size_t l : nearest) {
      const auto isBeside = [l](const LayerRange& range) { return l + 1 >= range.first && l <= range.end; };
      if (ranges.size() < kTogether && std::none_of(ranges.begin(), ranges.end(), isBeside))
        ranges.push_back({l, l + 1});
    }
    std::sort(ranges.begin(), ranges.end(),
              [](const LayerRange& a, const LayerRange& b) { return a.first < b.first; });
    return tried(std::move(ranges));
  }

  void add(const MachineCheck& found) {
    for (const Finding& finding : found.faults) is_hindered_[finding.at.layer] = 1;
    for (const Finding& finding : found.collisions) is_hindered_[finding.at.layer] = 1;
  }

 private:
  std::vector<LayerRange> tried(std::vector<LayerRange> ranges) {
    for (const LayerRange& range : ranges) is_tried_[range.first] = 1;
    return ranges;
  }

  std::vector<std::size_t> wayToHindered() const {
    const std::size_t count = is_hindered_.size();
    std::vector<std::size_t> way(count, count);
    for (std::size_t l = 0; l < count; ++l)
      if (is_hindered_[l] != 0)
        for (std::size_t other = 0; other < count; ++other)
          way[other] = std::min(way[other], other > l ? other - l : l - other);
    return way;
  }

  std::vector<char> is_tried_;
  std::vector<char> is_hindered_;
};

/// What is found in some layers as planned, and while their tool axes are raised, where that hinders the
/// least of their beads.
struct LeastHindered {
  MachineCheck check;
  double hindered_mm3 = std::numeric_limits<double>::infinity();
  std::vector<Finding> unmendable;  ///< as planned; nothing is raised then
};

/// Some layers of a stack.
struct LayerGroup {
  std::vector<LayerRange> ranges;
  Toolpath beads;
};

LeastHindered leastHindered(const Toolpath& planned, const LayerGroup& group, const RaisingSite& site,
                            const PlanCheck& check, const UnmendableFaults& unmendable) {
  LeastHindered least;
  const auto checked = [&](const Toolpath& toolpath) {
    MachineCheck found = check.of({toolpath, group.ranges});
    const double hindered_mm3 = hinderedVolume(found, group.beads);
    if (hindered_mm3 < least.hindered_mm3) {
      least.check = onBeads(found, group.beads);
      least.hindered_mm3 = hindered_mm3;
    }
    return found;
  };
  least.unmendable = unmendable(checked(planned));
  if (least.unmendable.empty() && least.hindered_mm3 > 0.0)
    raiseToolAxes(planned, site, checked, RaiseGoal::Fewest);
  return least;
}

/// With its findings in the order of the motion.
HopelessLayers inOrder(HopelessLayers found) {
  for (std::vector<Finding>* findings : {&found.check.faults, &found.check.collisions})
    std::stable_sort(findings->begin(), findings->end(),
                     [](const Finding& a, const Finding& b) { return a.at.layer < b.at.layer; });
  return found;
}

}  // namespace

double hinderedVolume(const MachineCheck& check, const Toolpath& beads) {
  // No way between beads is needed.
  const TravelMaker nowhere = [](const Path&, const Path&, std::size_t) { return std::nullopt; };
  return cutBeads(beads, hinderedBeads(onBeads(check, beads)), nowhere, 0.0).left_out_mm3;
}

std::optional<HopelessLayers> hopelessLayers(const Toolpath& planned, const RaisingSite& site,
                                             const PlanCheck& check, const UnmendableFaults& unmendable) {
  const double deposited_mm3 = totals(planned).deposited_mm3;
  HopelessLayers found;
  found.most_mm3 = 0.01 * site.settings.volumetric.largest_left_out_percent * deposited_mm3;
  LayersTried tried(planned.layers.size());
  for (std::size_t i = 0; i < kMostGroups; ++i) {
    LayerGroup group{i == 0 ? tried.spread() : tried.nearHindered(), {}};
    if (group.ranges.empty()) break;
    group.beads = beadsOf(planned, group.ranges);
    LeastHindered least = leastHindered(planned, group, site, check, unmendable);
    found.layers += group.ranges.size();
    if (!least.unmendable.empty()) {
      found.is_out_of_reach = true;
      found.check = {};
      found.check.faults = std::move(least.unmendable);
      return found;
    }
    tried.add(least.check);
    found.hindered_mm3 += least.hindered_mm3;
    append(std::move(least.check.faults), found.check.faults);
    append(std::move(least.check.collisions), found.check.collisions);
    if (found.hindered_mm3 > found.most_mm3) return inOrder(std::move(found));
    const double fair_mm3 = i == 0 ? found.most_mm3 * totals(group.beads).deposited_mm3 / deposited_mm3 : 0.0;
    if (least.hindered_mm3 <= fair_mm3) break;
  }
  return std::nullopt;
}

}  // namespace lamina
