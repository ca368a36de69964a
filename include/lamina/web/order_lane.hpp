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

/// Effect of an order on the unit.
enum class OrderEffect : std::uint8_t {
  Stops,  ///< stops it; a repeated order shares the answer of the waiting one
  Moves,  ///< lets it move; `dropMoves` drops the order if it was not begun
  Other
};

/// Whether a command keeps the unit from going on.
constexpr bool stopsUnit(UnitCommand command) {
  return command == UnitCommand::Hold || command == UnitCommand::Suspend || command == UnitCommand::Stop ||
         command == UnitCommand::Abort;
}

/// An order to another node of the cell.
struct LaneOrder {
  std::string kind;  ///< "Start": at most one order of a kind waits at a time
  OrderEffect effect = OrderEffect::Other;
  std::string node;                  ///< name of the node, for the answer if the node gives none
  double patience_s = 5.0;           ///< longest wait for its answer
  std::function<DeskAnswer()> call;  ///< gives the order and returns the answer
};

/// Gives orders one after the other, in the order in which they were asked for, in a thread of its own.
/// Callers wait for their answer for a limited time. An order that was not begun in that time is never given.
/// At most one order of each kind waits, and at most sixteen orders in all. May be called from several
/// threads.
class OrderLane {
 public:
  OrderLane();
  /// Waits for the call under way.
  ~OrderLane();
  OrderLane(const OrderLane&) = delete;
  OrderLane& operator=(const OrderLane&) = delete;

  /// Gives an order.
  /// @return the answer; `Overtaken` if the order was dropped, if another of its kind waits already (unless
  ///   it stops the unit), or if sixteen orders wait; `Silent` if it was not begun in time; `Unsure` if it
  ///   was begun, or is waited for by another caller, but has no answer in time
  DeskAnswer ask(LaneOrder order);

  /// Gives an order after those that wait, and does not wait for its answer. Without effect if one of its
  /// kind waits already.
  void post(LaneOrder order);

  /// Drops orders that would move the unit and were not begun yet. An order that was begun cannot be taken
  /// back: unless its answer shows that it was refused, `stop` is given once more after it, as is each stop
  /// of another kind for which this was called meanwhile.
  /// @param stop  the order that stops the unit
  void dropMoves(const LaneOrder& stop);

  /// Number of orders that were not begun yet.
  std::size_t waiting() const;

 private:
  struct Waiting;
  static DeskAnswer overtaken(const Waiting& waiting);
  void run();
  std::shared_ptr<Waiting> ofKind(const std::string& kind) const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Waiting>> waiting_;
  std::shared_ptr<Waiting> under_way_;  ///< order that is being given; null if none is
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lamina
