// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

namespace lamina {

/// The layer, or the next line, before which the job is to hold at the user's request.
class LayerPause {
 public:
  void set(double layer) { layer_ = static_cast<std::int32_t>(layer); }
  void setNextLine() { layer_ = kBelowAll; }
  void clear() { layer_.reset(); }

  /// Whether the job is to hold before the layer after this one, or before an earlier one.
  bool isNear(std::int32_t layer) const { return layer_ && layer >= *layer_ - 1; }

  /// Whether a line of this layer must wait. True once per request.
  bool isDueAt(std::int32_t layer) {
    if (!layer_ || layer < *layer_) return false;
    layer_.reset();
    return true;
  }

 private:
  static constexpr std::int32_t kBelowAll = -2;  // lines in front of the first layer have -1

  std::optional<std::int32_t> layer_;
};

}  // namespace lamina
