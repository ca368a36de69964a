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
  void setNextLine() { is_next_line_ = true; }
  void clearNextLine() { is_next_line_ = false; }

  /// Whether the job is to hold before the layer after this one, or before an earlier one.
  bool isNear(std::int32_t layer) const { return is_next_line_ || (layer_ && layer >= *layer_ - 1); }

  /// Whether a line of this layer must wait; takes the request, so that it is true once.
  bool takeIfDueAt(std::int32_t layer) {
    const bool is_layer = layer_ && layer >= *layer_;
    if (is_layer) layer_.reset();
    return std::exchange(is_next_line_, false) || is_layer;
  }

 private:
  std::optional<std::int32_t> layer_;
  bool is_next_line_ = false;
};

}  // namespace lamina
