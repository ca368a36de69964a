// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/stack_covers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "planning/order/near_origin.hpp"

namespace lamina {
namespace {

std::vector<StackStretch> stretchesOf(const std::vector<Layer>& layers, StackPlace place) {
  if (place == StackPlace::AlongBelt) return stretchesAlongBelt(layers);
  return {{0, layers.size(), Point2::Zero()}};
}

/// How many layers beside a layer decide what covers it, at most.
std::size_t greatestReach(const std::vector<double>& heights_mm, const SkinSettings& skins) {
  auto reach = static_cast<std::size_t>(std::max(skins.top_layers, skins.bottom_layers));
  const double thickest_mm = std::max(skins.top_mm, skins.bottom_mm);
  if (thickest_mm > 0.0 && !heights_mm.empty()) {
    const double least_mm = *std::min_element(heights_mm.begin(), heights_mm.end());
    reach = std::max(reach, static_cast<std::size_t>(std::ceil(thickest_mm / least_mm)));
  }
  return reach + 1;
}

}  // namespace

std::vector<LayerCover> stackCovers(const std::vector<Layer>& layers, const PlanSettings& settings,
                                    StackPlace place, Progress& progress) {
  std::vector<double> heights_mm;
  heights_mm.reserve(layers.size());
  for (const Layer& layer : layers) heights_mm.push_back(layer.bounds.height());
  const std::size_t reach = greatestReach(heights_mm, settings.skins);
  std::vector<LayerCover> all;
  all.reserve(layers.size());
  for (const StackStretch& stretch : stretchesOf(layers, place)) {
    const std::size_t begin = stretch.begin - std::min(stretch.begin, reach);
    const std::size_t end = std::min(layers.size(), stretch.end + reach);
    std::vector<Regions> material(end - begin);
    const auto unite_layer = [&](std::size_t i) {
      const std::vector<Polygon>& contours = layers[begin + i].section.contours;
      const bool is_away = !stretch.away.isZero();
      material[i] =
          unite(simplify(is_away ? moved(layers[begin + i], -stretch.away).section.contours : contours,
                         settings.simplification_mm));
    };
    parallelFor(material.size(), unite_layer, progress, "skins");
    const auto at = [&](std::size_t i) { return heights_mm.begin() + static_cast<std::ptrdiff_t>(i); };
    std::vector<LayerCover> covers =
        coversOf(std::move(material), {at(begin), at(end)}, settings.skins, progress);
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
      all.push_back(stretch.away.isZero() ? std::move(covers[i - begin])
                                          : moved(covers[i - begin], stretch.away));
  }
  return all;
}

}  // namespace lamina
