// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lamina/web/order_lane.hpp"

namespace lamina {

/// Lanes of orders to the nodes of a cell, two for each node: one for orders that stop the unit and one for
/// all others. An order waits neither behind orders to other nodes, which may hang, nor, if it is a stop,
/// behind orders that are none. May be called from several threads.
class NodeLanes {
 public:
  /// @param nodes  names of all nodes to which orders are given
  explicit NodeLanes(const std::vector<std::string>& nodes);

  /// Gives an order, as `OrderLane::ask` does. A stop first drops the orders to all nodes that would move the
  /// unit and were not begun yet (`OrderLane::dropMoves`). Given once more, it goes by the lane of its own
  /// node.
  /// @throws std::out_of_range if its node is none of those of the constructor
  DeskAnswer give(LaneOrder order);

 private:
  // By node; none is added later. Other orders are over before the lanes into which they give stops.
  std::map<std::string, OrderLane> stops_;
  std::map<std::string, OrderLane> orders_;
};

}  // namespace lamina
