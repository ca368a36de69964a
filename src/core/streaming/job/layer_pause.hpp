// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "lamina/streaming/job/live_change.hpp"
#include "streaming/job/job_record.hpp"

namespace lamina {

/// A pause requested by the user: before a layer, or before the next line.
class LayerPause {
 public:
  /// Records a change if it is such a request.
  bool take(const LiveChange& change) {
    if (change.setting != LiveSetting::PauseAtLayer) return false;
    layer_ = static_cast<std::int32_t>(change.value);
    return true;
  }

  enum class Wish : std::uint8_t {
    Refused,
    Kept,  ///< kept until the first line
    Begun,
  };
  /// Pauses a job at once: in Execute it becomes Holding; in Starting the request is kept.
  Wish pauseNow(JobRecord& record) {
    if (record.isStarting()) is_next_line_ = true;
    if (record.isStarting()) return Wish::Kept;
    if (record.status.state != PackmlState::Execute) return Wish::Refused;
    is_next_line_ = false;
    record.enter(PackmlState::Holding);
    return Wish::Begun;
  }
  /// Withdraws such a request of a job in Starting.
  /// @return whether the job is in Starting
  bool takeBack(const JobRecord& record) {
    if (record.isStarting()) is_next_line_ = false;
    return record.isStarting();
  }

  /// Whether the job is to hold before the layer after this one, or before an earlier one.
  bool isNear(std::int32_t layer) const { return is_next_line_ || (layer_ && layer >= *layer_ - 1); }

  /// Whether a line of this layer must wait. Removes the request, so that the result is true only once.
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
