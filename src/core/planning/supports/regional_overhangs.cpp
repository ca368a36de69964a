// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/regional_overhangs.hpp"

#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/bridges/bridged_areas.hpp"
#include "planning/supports/overhang_areas.hpp"

namespace lamina {
namespace {

/// That hold what they span, if there are any.
std::optional<HoldingBridges> holdingBridges(const PlanSettings& settings, double layer_height_mm) {
  const BridgeSettings& bridges = settings.bridges;
  if (!bridges.is_used || settings.supports.under_bridges) return std::nullopt;
  const double width_mm = settings.bead.width_mm;
  const double pitch_mm = planWidth({width_mm, layer_height_mm});
  return HoldingBridges{{bridges.anchor_mm, threadPitch(bridges, width_mm, pitch_mm), bridges.least_held},
                        bridges.longest_mm};
}

/// Whether both hold up the same overhangs.
bool holdAlike(const PlanSettings& a, const PlanSettings& b) {
  const auto rules = [](const PlanSettings& settings) {
    const BridgeSettings& bridges = settings.bridges;
    return std::tie(settings.supports.use, settings.supports.angle_deg, settings.supports.under_bridges,
                    bridges.is_used, bridges.anchor_mm, bridges.least_held, bridges.longest_mm,
                    bridges.thread, bridges.thread_mm);
  };
  return rules(a) == rules(b);
}

const Regions& areaIn(const std::vector<Regions>& by_layer, std::size_t layer) {
  static const Regions kNone;
  return layer < by_layer.size() ? by_layer[layer] : kNone;
}

class OverhangSearch {
 public:
  OverhangSearch(const StackedMaterial& stack, double layer_height_mm, Progress& progress)
      : stack_(stack), layer_height_mm_(layer_height_mm), progress_(progress) {}

  std::vector<Regions> by(const PlanSettings& settings) const {
    if (!settings.supports.use) return std::vector<Regions>(stack_.size());
    return overhangAreas(stack_, settings.supports, progress_, holdingBridges(settings, layer_height_mm_));
  }

  /// All that has nothing below it, within an area.
  Regions overNothing(std::size_t layer, const Regions& area) const {
    if (layer == 0 || area.empty() || stack_.material[layer] == stack_.material[layer - 1]) return {};
    const Regions below = united(*stack_.material[layer - 1], stack_.bedIn(layer - 1));
    return difference(intersection(*stack_.material[layer], area), below);
  }

 private:
  const StackedMaterial& stack_;
  double layer_height_mm_;
  Progress& progress_;
};

}  // namespace

RegionalOverhangs regionalOverhangs(const StackedMaterial& stack, const PlanSettings& settings,
                                    const SupportRegions& regions, double layer_height_mm,
                                    Progress& progress) {
  const OverhangSearch search(stack, layer_height_mm, progress);
  const SupportMarks none;
  const SupportMarks& marks = regions.marks != nullptr ? *regions.marks : none;
  PlanSettings unmarked = settings;
  unmarked.supports.use = settings.supports.use && marks.unmarked == UnmarkedOverhangs::ByAngle;
  RegionalOverhangs found{search.by(unmarked), 0.0};
  if (regions.variants != nullptr)
    for (const PlanVariant& variant : *regions.variants) {
      if (holdAlike(variant.settings, unmarked)) continue;
      const std::vector<Regions> own = search.by(variant.settings);
      for (std::size_t i = 0; i < stack.size(); ++i)
        if (const Regions& area = areaIn(variant.areas, i); !area.empty())
          found.held[i] = united(difference(found.held[i], area), intersection(own[i], area));
    }
  std::vector<double> blocked_mm2(stack.size(), 0.0);
  const auto mark = [&](std::size_t i) {
    Regions& held = found.held[i];
    if (const Regions& never = areaIn(marks.never, i); !never.empty() && !held.empty()) {
      Regions rest = difference(held, never);
      blocked_mm2[i] = area(held) - area(rest);
      held = std::move(rest);
    }
    if (const Regions forced = search.overNothing(i, areaIn(marks.always, i)); !forced.empty())
      held = united(held, forced);
  };
  parallelFor(stack.size(), mark, progress, "supports");
  for (const double mm2 : blocked_mm2) found.blocked_mm2 += mm2;
  return found;
}

}  // namespace lamina
