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

/// Rests a motion in front of each layer but the first until its map has come, and says which plan the motion
/// may be gone on with from there. Maps that come after their layer was handed over change nothing any more:
/// it is not, before they are there. Times are those of the feeder's clock.
class MapWait {
 public:
  /// Whether the machine stands still, as far as is known.
  enum class Motion { Moves, Rests };

  /// @param wait_s  for a map, at rest
  /// Feeder and correction must outlive this.
  MapWait(TrajectoryFeeder& feeder, ChunkCorrection& correction, double wait_s);

  /// What is to be done before more is handed over; while the motion is not paused.
  /// @return whether it goes on from rest into a layer now
  bool look(double now_s, Motion motion);
  /// The motion goes on after a pause: where that was in front of a layer, its map is waited for anew.
  void resume(double now_s);

  /// The layers left planned anew. The latest plan holds; until it is refused or driven the layer in front of
  /// which the motion is held is not entered.
  /// @return why it is not used, in words; empty if it is. The correction reports a plan that is not used.
  std::string offer(const lamina_msgs::ToolpathConstPtr& plan);
  /// The plan to be gone on with once the motion rests; null if there is none.
  const lamina_msgs::ToolpathConstPtr& plan() const { return plan_; }
  /// A plan that cannot be driven is not tried again: the layer's map is waited for anew.
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
  std::optional<double> rests_at_;  ///< since when it does
  lamina_msgs::ToolpathConstPtr plan_;
  bool has_passed_ = false;  ///< a layer without a stop
  std::string notice_;
};

}  // namespace lamina
