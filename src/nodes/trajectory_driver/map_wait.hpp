// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "chunk_correction.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"
#include "messages.hpp"

namespace lamina {

/// Rests a motion in front of each layer except the first until the layer's map has come, and states the plan
/// with which the motion may continue there. A layer is not handed over before its map, as later maps change
/// nothing. Times are those of the feeder's clock.
class MapWait {
 public:
  /// Whether the machine stands still, as far as is known.
  enum class Motion { Moves, Rests };

  /// @param feeder, correction  must outlive this
  /// @param wait_s  longest wait for a map, at rest
  MapWait(TrajectoryFeeder& feeder, ChunkCorrection& correction, double wait_s);

  /// Does what is due before more is handed over; to be called while the motion is not paused.
  /// @return whether the motion continues from rest into a layer now
  bool look(double now_s, Motion motion);
  /// States that the motion continues after a pause: after a pause in front of a layer the layer's map is
  /// awaited anew.
  void resume(double now_s);

  /// Takes a new plan of the remaining layers. The latest plan holds; until it is refused or driven, the
  /// motion does not enter the layer in front of which it is held.
  /// @return why it is not used, in words; empty if it is. The correction reports a plan that is not used.
  std::string offer(const lamina_msgs::ToolpathConstPtr& plan);
  /// The plan to be followed once the motion rests; null if there is none.
  const lamina_msgs::ToolpathConstPtr& plan() const { return plan_; }
  /// States that a plan cannot be driven. It is not tried again: the layer's map is awaited anew.
  void refuse(const std::string& plan_id, const std::string& reason);

  /// What an operator should know, in words, once; empty if there is nothing new.
  std::string takeNotice() { return std::exchange(notice_, {}); }

 private:
  void holdAtNext(double now_s);
  void enter(double now_s);
  void passLayer();

  TrajectoryFeeder& feeder_;
  ChunkCorrection& correction_;
  double wait_s_;
  std::size_t awaited_ = 1;         ///< layer in front of which the motion is to rest
  std::optional<double> rests_at_;  ///< time since which the motion rests
  lamina_msgs::ToolpathConstPtr plan_;
  bool has_passed_ = false;  ///< whether a layer was entered without a stop
  std::string notice_;
};

}  // namespace lamina
