// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/adaptive_heights/adaptive_layers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "slicing/adaptive_heights/height_limits.hpp"

namespace lamina {
namespace {

/// Heights between two places at which a layer ends.
struct HeightStretch {
  double low_mm = 0.0;
  double high_mm = 0.0;
  /// Of the layers at its ends, for those beyond.
  double limit_at_low_mm = std::numeric_limits<double>::infinity();
  double limit_at_high_mm = std::numeric_limits<double>::infinity();
};

/// Cuts stretches into layers.
class StretchCutter {
 public:
  StretchCutter(const SlopeProfile& profile, const AdaptiveSettings& settings);

  /// Where layers begin and end, both ends of the stretch included, as few and as high as limits allow: what
  /// is too much in all is taken from what each has above the least height. None if layers of the least
  /// height do not go into it.
  std::optional<std::vector<double>> cut(const HeightStretch& stretch);

  /// Where the highest layers from `low_mm` end, the last one at or above `high_mm`.
  std::vector<double> highest(const HeightStretch& stretch);

  double least() const { return least_mm_; }
  double growth() const { return up_.growth(); }

 private:
  double heightAt(HeightLimits& limits, double bottom_mm, const HeightStretch& stretch) const;
  std::vector<double> ends(HeightLimits& limits, const HeightStretch& stretch) const;

  HeightLimits up_;
  HeightLimits down_;
  double least_mm_;
  double quantum_mm_;
};

constexpr double kSameHeight = 1e-9;  // mm
constexpr std::size_t kMostLayersOfPart = 10000000;

/// With the quantum, the least multiple that is not lower.
double leastHeight(const AdaptiveSettings& settings) {
  if (settings.quantum_mm == 0.0) return settings.least_mm;
  const double least_mm =
      std::ceil(settings.least_mm / settings.quantum_mm - kSameHeight) * settings.quantum_mm;
  if (least_mm > settings.greatest_mm + kSameHeight)
    throw InvalidConfig("adaptive.quantum_mm is " + numberText(settings.quantum_mm) +
                        " mm; expected a multiple of it between adaptive.least_mm, " +
                        numberText(settings.least_mm) + " mm, and adaptive.greatest_mm, " +
                        numberText(settings.greatest_mm) + " mm");
  return least_mm;
}

HeightStretch mirroredStretch(const HeightStretch& stretch) {
  return {-stretch.high_mm, -stretch.low_mm, stretch.limit_at_high_mm, stretch.limit_at_low_mm};
}

StretchCutter::StretchCutter(const SlopeProfile& profile, const AdaptiveSettings& settings)
    : up_(profile, settings),
      down_(up_.mirrored()),
      least_mm_(leastHeight(settings)),
      quantum_mm_(settings.quantum_mm) {}

double StretchCutter::heightAt(HeightLimits& limits, double bottom_mm, const HeightStretch& stretch) const {
  const double growth = limits.growth();
  const double left = stretch.high_mm - bottom_mm;
  double height = limits.above(bottom_mm);
  height = std::min(height, stretch.limit_at_low_mm + growth * (bottom_mm - stretch.low_mm));
  if (left > stretch.limit_at_high_mm)
    height = std::min(height, (stretch.limit_at_high_mm + growth * left) / (1.0 + growth));
  if (quantum_mm_ > 0.0) height = std::floor(height / quantum_mm_ + 1e-6) * quantum_mm_;
  return std::max(height, least_mm_);
}

std::vector<double> StretchCutter::ends(HeightLimits& limits, const HeightStretch& stretch) const {
  std::vector<double> ends = {stretch.low_mm};
  while (ends.back() < stretch.high_mm - kSameHeight) {
    ends.push_back(ends.back() + heightAt(limits, ends.back(), stretch));
    if (ends.size() > kMostLayersOfPart)
      throw InvalidConfig("adaptive.least_mm is " + numberText(least_mm_) +
                          " mm; the part would have more than 10 million layers");
  }
  return ends;
}

std::vector<double> StretchCutter::highest(const HeightStretch& stretch) { return ends(up_, stretch); }

std::optional<std::vector<double>> StretchCutter::cut(const HeightStretch& stretch) {
  const std::vector<double> upwards = ends(up_, stretch);
  const std::size_t count = upwards.size() - 1;
  const double length = stretch.high_mm - stretch.low_mm;
  const double least_length = static_cast<double>(count) * least_mm_;
  if (least_length > length + kSameHeight) return std::nullopt;
  // As low as a place may be for the layers above it to reach the end.
  std::vector<double> downwards = ends(down_, mirroredStretch(stretch));
  while (downwards.size() <= count) downwards.push_back(downwards.back() - least_mm_);

  const double excess = upwards.back() - stretch.low_mm - least_length;
  const double share = excess > kSameHeight ? (length - least_length) / excess : 0.0;
  std::vector<double> places = {stretch.low_mm};
  double wanted = stretch.low_mm;
  for (std::size_t i = 1; i < count; ++i) {
    wanted += least_mm_ + share * (upwards[i] - upwards[i - 1] - least_mm_);
    double place = wanted;
    if (quantum_mm_ > 0.0)
      place = stretch.low_mm + std::round((wanted - stretch.low_mm) / quantum_mm_) * quantum_mm_;
    place = std::max(place, -downwards[count - i]);
    place = std::min(place, places.back() + heightAt(up_, places.back(), stretch));
    if (place - places.back() < least_mm_ - kSameHeight) return std::nullopt;
    places.push_back(place);
  }
  if (stretch.high_mm - places.back() < least_mm_ - kSameHeight) return std::nullopt;
  places.push_back(stretch.high_mm);
  return places;
}

constexpr double kSamePlace = 1e-9;  // mm
constexpr int kMostRounds = 30;

/// A stretch and the places where its layers end.
struct CutStretch {
  HeightStretch stretch;
  std::vector<double> places;

  double lowest() const { return places[1] - places[0]; }
  double highest() const { return places.back() - places[places.size() - 2]; }
};

/// The nearest place to a flat at which a layer can end, if none can end at the flat itself.
double nearestPlace(StretchCutter& cutter, const HeightStretch& stretch) {
  const std::vector<double> upwards = cutter.highest(stretch);
  const double below = upwards[upwards.size() - 2];
  const double above = stretch.low_mm + static_cast<double>(upwards.size() - 1) * cutter.least();
  return stretch.high_mm - below <= above - stretch.high_mm ? below : above;
}

/// With a quantum, the multiple of it that is nearest to a flat.
double reachable(double z_mm, double from_mm, double quantum_mm) {
  if (quantum_mm == 0.0) return z_mm;
  return from_mm + std::round((z_mm - from_mm) / quantum_mm) * quantum_mm;
}

/// Stretches from flat to flat, as far as layers can end there.
/// @param top_mm  of the part
std::vector<CutStretch> cutAtFlats(StretchCutter& cutter, const std::vector<Flat>& flats, HeightStretch whole,
                                   double quantum_mm) {
  std::vector<double> wanted;
  wanted.reserve(flats.size() + 1);
  for (const Flat& flat : flats) wanted.push_back(flat.z_mm);
  if (wanted.empty() || wanted.back() < whole.high_mm - kSamePlace) wanted.push_back(whole.high_mm);
  std::vector<CutStretch> stretches;
  double from_mm = whole.low_mm;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const bool is_last = i + 1 == wanted.size();
    double to_mm = reachable(wanted[i], whole.low_mm, quantum_mm);
    if (to_mm < from_mm + 0.5 * cutter.least()) continue;
    HeightStretch stretch{from_mm, to_mm,
                          stretches.empty() ? whole.limit_at_low_mm : HeightStretch().limit_at_low_mm};
    auto places = cutter.cut(stretch);
    if (!places) {
      to_mm = nearestPlace(cutter, stretch);
      const bool leaves_room = is_last || wanted[i + 1] - to_mm >= cutter.least();
      if (to_mm < from_mm + 0.5 * cutter.least() || !leaves_room) continue;
      stretch.high_mm = to_mm;
      places = cutter.cut(stretch);
    }
    if (!places) continue;
    stretches.push_back({stretch, std::move(*places)});
    from_mm = to_mm;
  }
  return stretches;
}

/// Lowers layers next to a stretch of lower ones, as the ratio of neighbours asks.
/// @return whether any was
bool smoothBorders(StretchCutter& cutter, std::vector<CutStretch>& stretches) {
  const double ratio = 1.0 + cutter.growth();
  bool is_changed = false;
  const auto recut = [&](CutStretch& each, const HeightStretch& limited) {
    auto places = cutter.cut(limited);
    if (!places) return;
    is_changed |= *places != each.places;
    each = {limited, std::move(*places)};
  };
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    CutStretch& below = stretches[i - 1];
    CutStretch& above = stretches[i];
    HeightStretch limited_below = below.stretch;
    HeightStretch limited_above = above.stretch;
    limited_below.limit_at_high_mm = std::min(limited_below.limit_at_high_mm, ratio * above.lowest());
    limited_above.limit_at_low_mm = std::min(limited_above.limit_at_low_mm, ratio * below.highest());
    if (below.highest() > ratio * above.lowest() + kSamePlace) recut(below, limited_below);
    if (above.lowest() > ratio * below.highest() + kSamePlace) recut(above, limited_above);
  }
  return is_changed;
}

std::vector<MissedFlat> missedFlats(const Flats& flats, const std::vector<LayerBounds>& bounds) {
  std::vector<Flat> all = flats.kept;
  all.insert(all.end(), flats.hidden.begin(), flats.hidden.end());
  std::sort(all.begin(), all.end(), [](const Flat& a, const Flat& b) { return a.z_mm < b.z_mm; });
  std::vector<MissedFlat> missed;
  for (const Flat& flat : all) {
    const auto above =
        std::lower_bound(bounds.begin(), bounds.end(), flat.z_mm,
                         [](const LayerBounds& layer, double z_mm) { return layer.top_mm < z_mm; });
    double off_mm = above == bounds.end() ? flat.z_mm - bounds.back().top_mm
                                          : std::min(above->top_mm - flat.z_mm, flat.z_mm - above->bottom_mm);
    off_mm = std::abs(off_mm);
    if (off_mm > kSamePlace) missed.push_back({flat.z_mm, off_mm});
  }
  return missed;
}

/// The places beyond the last stretch, if layers could not end at the part's top.
void addRest(StretchCutter& cutter, double top_mm, std::vector<LayerBounds>& bounds) {
  const double from_mm = bounds.back().top_mm;
  if (from_mm >= top_mm - kSamePlace) return;
  const std::vector<double> places = cutter.highest({from_mm, top_mm});
  for (std::size_t i = 1; i < places.size(); ++i) bounds.push_back({places[i - 1], places[i]});
}

}  // namespace

AdaptiveLayers adaptiveLayers(const Mesh& mesh, const SlicingSettings& settings) {
  const AdaptiveSettings& adaptive = settings.adaptive;
  const Box3 box = boundingBox(mesh);
  SlicingSettings first_alone = settings;
  first_alone.layer_height_mm = std::max(box.size().z(), settings.first_layer_height_mm) * 4.0;
  AdaptiveLayers layers;
  layers.bounds = stackLayers(box.low.z(), box.high.z(), first_alone);
  if (layers.bounds.empty()) return layers;
  layers.bounds.resize(1);
  const double first_top = layers.bounds.front().top_mm;
  StretchCutter cutter(slopeProfile(mesh, adaptive.least_mm), adaptive);
  Flats flats = flatsOf(mesh, adaptive.least_mm);
  std::vector<Flat> above_first = flats.kept;
  above_first.erase(std::remove_if(above_first.begin(), above_first.end(),
                                   [&](const Flat& flat) { return flat.z_mm <= first_top + kSamePlace; }),
                    above_first.end());
  if (box.high.z() > first_top + kSamePlace) {
    HeightStretch whole{first_top, box.high.z()};
    whole.limit_at_low_mm = adaptive.greatest_ratio * settings.first_layer_height_mm;
    std::vector<CutStretch> stretches = cutAtFlats(cutter, above_first, whole, adaptive.quantum_mm);
    for (int round = 0; round < kMostRounds && smoothBorders(cutter, stretches); ++round) {
    }
    for (const CutStretch& each : stretches)
      for (std::size_t i = 1; i < each.places.size(); ++i)
        layers.bounds.push_back({each.places[i - 1], each.places[i]});
    addRest(cutter, box.high.z(), layers.bounds);
  }
  while (!(layers.bounds.back().cut() < box.high.z())) layers.bounds.pop_back();
  layers.missed = missedFlats(flats, layers.bounds);
  return layers;
}

double greatestCusp(const Mesh& mesh, const std::vector<LayerBounds>& bounds) {
  if (bounds.empty()) return 0.0;
  double least_mm = bounds.front().height();
  double greatest_mm = least_mm;
  for (const LayerBounds& layer : bounds) {
    least_mm = std::min(least_mm, layer.height());
    greatest_mm = std::max(greatest_mm, layer.height());
  }
  double cusp_mm = 0.0;
  for (const Triangle& corners : mesh.triangles) {
    const FaceSlope face = slopeOf(mesh, corners);
    if (face.slope * greatest_mm <= cusp_mm || face.isFlat(least_mm)) continue;
    auto layer = std::lower_bound(bounds.begin(), bounds.end(), face.low_mm + kSamePlace,
                                  [](const LayerBounds& each, double z_mm) { return each.top_mm <= z_mm; });
    for (; layer != bounds.end() && layer->bottom_mm < face.high_mm - kSamePlace; ++layer)
      cusp_mm = std::max(cusp_mm, face.slope * layer->height());
  }
  return cusp_mm;
}

}  // namespace lamina
