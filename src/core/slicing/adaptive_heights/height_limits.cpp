// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adaptive_heights/height_limits.hpp"

#include <algorithm>
#include <iterator>

namespace lamina {

HeightLimits::HeightLimits(const SlopeProfile& profile, const AdaptiveSettings& settings)
    : z_mm_(profile.z_mm), greatest_mm_(settings.greatest_mm), growth_(settings.greatest_ratio - 1.0) {
  between_mm_.reserve(profile.slope.size());
  for (const double slope : profile.slope) {
    const bool is_limited = slope * settings.greatest_mm > settings.cusp_mm;
    between_mm_.push_back(is_limited ? std::max(settings.least_mm, settings.cusp_mm / slope)
                                     : settings.greatest_mm);
  }
  spread();
}

void HeightLimits::spread() {
  at_mm_.assign(z_mm_.size(), greatest_mm_);
  for (std::size_t i = 0; i + 1 < z_mm_.size(); ++i) {
    at_mm_[i] = std::min(at_mm_[i], between_mm_[i]);
    at_mm_[i + 1] = std::min(at_mm_[i + 1], between_mm_[i]);
  }
  for (std::size_t i = 1; i < z_mm_.size(); ++i)
    at_mm_[i] = std::min(at_mm_[i], at_mm_[i - 1] + growth_ * (z_mm_[i] - z_mm_[i - 1]));
  for (std::size_t i = z_mm_.size(); i-- > 1;)
    at_mm_[i - 1] = std::min(at_mm_[i - 1], at_mm_[i] + growth_ * (z_mm_[i] - z_mm_[i - 1]));
}

HeightLimits HeightLimits::mirrored() const {
  HeightLimits other;
  other.greatest_mm_ = greatest_mm_;
  other.growth_ = growth_;
  std::transform(z_mm_.rbegin(), z_mm_.rend(), std::back_inserter(other.z_mm_), [](double z) { return -z; });
  other.at_mm_.assign(at_mm_.rbegin(), at_mm_.rend());
  other.between_mm_.assign(between_mm_.rbegin(), between_mm_.rend());
  return other;
}

double HeightLimits::above(double bottom_mm) {
  if (next_ > 0 && z_mm_[next_ - 1] > bottom_mm) next_ = 0;
  while (next_ < z_mm_.size() && z_mm_[next_] <= bottom_mm) ++next_;
  double height = greatest_mm_;
  if (next_ > 0) height = std::min(height, at_mm_[next_ - 1] + growth_ * (bottom_mm - z_mm_[next_ - 1]));
  if (next_ > 0 && next_ < z_mm_.size()) height = std::min(height, between_mm_[next_ - 1]);
  for (std::size_t i = next_; i < z_mm_.size(); ++i) {
    const double distance = z_mm_[i] - bottom_mm;
    // Up to this z, a layer of height h may have what is allowed at a distance of z - h.
    if (at_mm_[i] < distance) return std::min(height, (at_mm_[i] + growth_ * distance) / (1.0 + growth_));
    if (height <= distance) return height;
    height = std::min(height, at_mm_[i]);
  }
  return height;
}

}  // namespace lamina
