// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "lamina/web/cell_desk.hpp"

namespace lamina {

/// What an order does to the unit.
enum class OrderEffect : std::uint8_t {
  Stops,  ///< given whatever waits; several of a kind are one
  Moves,  ///< dropped when the unit is stopped before it was begun
  Other
};

/// An order to another node.
struct LaneOrder {
  std::string kind;  ///< "Start": of equal ones, one waits at a time
  OrderEffect effect = OrderEffect::Other;
  std::string node;         ///< that is asked, for the answer if it gives none
  double patience_s = 5.0;  ///< for its answer
  std::function<DeskAnswer()> call;
};

/// Gives orders one after the other in a thread of its own, and waits for each answer for a bounded time. An
/// order that was not begun in that time is never given. Of each kind, one waits at a time; sixteen kinds at
/// most. Several threads ask at a time.
class OrderLane {
 public:
  OrderLane();
  /// Waits for the call under way.
  ~OrderLane();
  OrderLane(const OrderLane&) = delete;
  OrderLane& operator=(const OrderLane&) = delete;

  /// @return the answer; `Overtaken` if the order was dropped, or another of its kind waits already; `Silent`
  /// if it was not begun in time, `Unsure` if it was
  DeskAnswer ask(LaneOrder order);

  /// Drops orders that would move the unit and were not begun yet. One that is on its way cannot be taken
  /// back: if it turns out not to have been refused, what stops the unit is given after it once more.
  /// @param stop  what stops it, with its kind: "Hold"
  void dropMoves(const LaneOrder& stop);

  /// Orders that were not begun yet.
  std::size_t waiting() const;

 private:
  struct Waiting;
  void run();
  std::shared_ptr<Waiting> ofKind(const std::string& kind) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Waiting>> waiting_;
  std::shared_ptr<Waiting> under_way_;  ///< that is being given; null if none is
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
