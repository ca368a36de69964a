// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/skins/layer_cover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polygon/region_lists.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/strategy.hpp"
#include "planning/order/near_origin.hpp"

namespace lamina {
namespace {

/// Stretches of the stack that are worked off apart from each other, of fixed length so that the result does
/// not depend on threads.
constexpr std::size_t kStretch = 64;

constexpr double kRounding = 1e-9;

SharedRegions common(const SharedRegions& a, const SharedRegions& b) {
  if (a == b || a->empty()) return a;
  if (b->empty()) return b;
  return std::make_shared<const Regions>(intersection(*a, *b));
}

/// A queue of regions that knows what all of them have in common, with three intersections for each at most.
class RunningIntersection {
 public:
  void push(SharedRegions regions) {
    back_common_ = back_.empty() ? regions : common(back_common_, regions);
    back_.push_back(std::move(regions));
  }
  void pop() {
    if (front_.empty()) {
      // From now on: what each has in common with those that came after it.
      for (; !back_.empty(); back_.pop_back())
        front_.push_back(front_.empty() ? back_.back() : common(back_.back(), front_.back()));
    }
    front_.pop_back();
  }
  std::size_t size() const { return front_.size() + back_.size(); }
  /// At least one must be held.
  SharedRegions value() const {
    if (front_.empty()) return back_common_;
    return back_.empty() ? front_.back() : common(front_.back(), back_common_);
  }

 private:
  std::vector<SharedRegions> front_;  ///< the oldest last, each with all after it
  std::vector<SharedRegions> back_;
  SharedRegions back_common_;
};

/// How many layers a skin counts from each one on; 0 for none.
/// @param heights_mm  in the direction in which the skin counts
std::vector<std::size_t> skinCounts(const std::vector<double>& heights_mm, int least_count, double least_mm) {
  std::vector<std::size_t> counts(heights_mm.size(), static_cast<std::size_t>(least_count));
  if (least_count == 0 && least_mm == 0.0) return counts;
  for (std::size_t i = 0; i < heights_mm.size(); ++i) {
    double sum_mm = 0.0;
    std::size_t count = 0;
    for (std::size_t j = i; j < heights_mm.size() && sum_mm < least_mm - kRounding; ++j, ++count)
      sum_mm += heights_mm[j];
    counts[i] = std::max(counts[i], count);
  }
  return counts;
}

/// For each layer, what is material in all of as many layers behind it. Beyond the last one there is none.
/// @param counts  of layers that each skin counts, itself among them; they fall by one a layer at most
std::vector<SharedRegions> windows(const std::vector<SharedRegions>& layers,
                                   const std::vector<std::size_t>& counts, Progress& progress) {
  static const SharedRegions nothing = std::make_shared<const Regions>();
  std::vector<SharedRegions> found(layers.size(), nothing);
  const auto work = [&](std::size_t stretch) {
    RunningIntersection window;
    std::size_t next = stretch * kStretch + 1;  // to be pushed
    const std::size_t end = std::min(layers.size(), (stretch + 1) * kStretch);
    for (std::size_t i = stretch * kStretch; i < end; ++i) {
      if (counts[i] == 0) {
        found[i] = layers[i];
        next = i + 2;
        window = {};
        continue;
      }
      for (; next <= i + counts[i]; ++next) window.push(next < layers.size() ? layers[next] : nothing);
      found[i] = window.value();
      window.pop();
    }
  };
  parallelFor((layers.size() + kStretch - 1) / kStretch, work, progress, "skins");
  return found;
}

template <class Value>
std::vector<Value> reversedOrder(std::vector<Value> values) {
  std::reverse(values.begin(), values.end());
  return values;
}

std::vector<SharedRegions> shared(std::vector<Regions> material) {
  std::vector<SharedRegions> layers;
  layers.reserve(material.size());
  for (Regions& regions : material) {
    const bool is_same = !layers.empty() && areEqual(*layers.back(), regions);
    layers.push_back(is_same ? layers.back() : std::make_shared<const Regions>(std::move(regions)));
  }
  return layers;
}

/// What wholly covers each layer from above and from below.
struct WholeCovers {
  std::vector<SharedRegions> above;
  std::vector<SharedRegions> below;
};

/// Both are the same windows where as many layers count above as below.
WholeCovers equalWindows(std::vector<SharedRegions> layers, std::size_t count, Progress& progress) {
  const std::size_t layer_count = layers.size();
  const SharedRegions nothing = std::make_shared<const Regions>();
  layers.insert(layers.begin(), nothing);
  const std::vector<SharedRegions> from =
      windows(layers, std::vector<std::size_t>(layers.size(), count), progress);
  WholeCovers covers;
  for (std::size_t i = 0; i < layer_count; ++i) {
    covers.above.push_back(from[i + 1]);
    covers.below.push_back(i >= count ? from[i - count] : nothing);
  }
  return covers;
}

WholeCovers wholeCovers(const std::vector<SharedRegions>& layers, const std::vector<double>& heights_mm,
                        const SkinSettings& settings, Progress& progress) {
  const bool counts_layers = settings.top_mm == 0.0 && settings.bottom_mm == 0.0;
  if (counts_layers && settings.top_layers == settings.bottom_layers && settings.top_layers > 0)
    return equalWindows(layers, static_cast<std::size_t>(settings.top_layers), progress);
  WholeCovers covers;
  covers.above = windows(layers, skinCounts(heights_mm, settings.top_layers, settings.top_mm), progress);
  covers.below = reversedOrder(
      windows(reversedOrder(layers),
              skinCounts(reversedOrder(heights_mm), settings.bottom_layers, settings.bottom_mm), progress));
  return covers;
}

}  // namespace

bool takesSkins(const PlanSettings& settings) {
  if (!hasSkins(settings.skins) || isSolid(settings.infill)) return false;
  const InfillStrategy strategy = infillStrategy(settings.infill.strategy);
  return strategy.deposit == Deposit::Bead && strategy.link == LayerLink::Travel;
}

std::size_t skinCount(int layers, double thickness_mm, double layer_height_mm) {
  const double by_thickness = std::ceil(thickness_mm / layer_height_mm - kRounding);
  return static_cast<std::size_t>(std::max(static_cast<double>(layers), by_thickness));
}

LayerCover moved(const LayerCover& cover, const Point2& by) {
  const auto moved_regions = [&by](const SharedRegions& regions) {
    return std::make_shared<const Regions>(moved(*regions, by));
  };
  LayerCover at;
  at.material = moved_regions(cover.material);
  // What is the same layer stays so: it costs nothing then.
  const auto unless_same = [&](const SharedRegions& regions) {
    return regions == cover.material ? at.material : moved_regions(regions);
  };
  at.above = unless_same(cover.above);
  at.below = unless_same(cover.below);
  at.whole = unless_same(cover.whole);
  return at;
}

std::vector<LayerCover> coversOf(std::vector<Regions> material, const std::vector<double>& heights_mm,
                                 const SkinSettings& settings, Progress& progress) {
  const std::vector<SharedRegions> layers = shared(std::move(material));
  const WholeCovers whole = wholeCovers(layers, heights_mm, settings, progress);
  const auto nothing = std::make_shared<const Regions>();
  std::vector<LayerCover> covers(layers.size());
  const auto cover = [&](std::size_t i) {
    covers[i].material = layers[i];
    covers[i].above = i + 1 < layers.size() ? layers[i + 1] : nothing;
    covers[i].below = i > 0 ? layers[i - 1] : nothing;
    covers[i].whole = common(whole.above[i], whole.below[i]);
  };
  parallelFor(layers.size(), cover, progress, "skins");
  return covers;
}

}  // namespace lamina
