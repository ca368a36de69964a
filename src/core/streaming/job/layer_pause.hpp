// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "lamina/streaming/job/live_change.hpp"
#include "streaming/job/job_record.hpp"

namespace lamina {

/// The layer, or the next line, before which the job is to hold at the user's request.
class LayerPause {
 public:
  /// Takes a change if it is such a request.
  bool take(const LiveChange& change) {
    if (change.setting != LiveSetting::PauseAtLayer) return false;
    layer_ = static_cast<std::int32_t>(change.value);
    return true;
  }

  enum class Wish : std::uint8_t {
    Refused,
    Kept,  ///< for the first line
    Begun,
  };
  /// Takes the wish to pause a job at once. One that is Starting keeps it; one in Execute is Holding then.
  Wish pauseNow(JobRecord& record) {
    if (record.isStarting()) is_next_line_ = true;
    if (record.isStarting()) return Wish::Kept;
    if (record.status.state != PackmlState::Execute) return Wish::Refused;
    is_next_line_ = false;
    record.enter(PackmlState::Holding);
    return Wish::Begun;
  }
  /// Takes back such a wish of a job that is Starting.
  /// @return whether it is Starting
  bool takeBack(const JobRecord& record) {
    if (record.isStarting()) is_next_line_ = false;
    return record.isStarting();
  }

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
