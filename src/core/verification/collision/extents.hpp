// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A box, and an interval along the layers' normal: inclined layers are thin along that alone [mm, bed
/// frame].
struct Extents {
  Box3 box;
  double low_normal = std::numeric_limits<double>::infinity();
  double high_normal = -std::numeric_limits<double>::infinity();

  void include(const Extents& other) {
    box.low = box.low.cwiseMin(other.box.low);
    box.high = box.high.cwiseMax(other.box.high);
    low_normal = std::min(low_normal, other.low_normal);
    high_normal = std::max(high_normal, other.high_normal);
  }

  bool meets(const Extents& other) const {
    return low_normal <= other.high_normal && other.low_normal <= high_normal &&
           (box.low.array() <= other.box.high.array()).all() &&
           (other.box.low.array() <= box.high.array()).all();
  }
};

}  // namespace lamina
