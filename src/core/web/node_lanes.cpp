// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/node_lanes.hpp"

#include <utility>

namespace lamina {

NodeLanes::NodeLanes(const std::vector<std::string>& nodes) {
  for (const std::string& node : nodes) {
    stops_.try_emplace(node);
    orders_.try_emplace(node);
  }
}

DeskAnswer NodeLanes::give(LaneOrder order) {
  OrderLane& own = stops_.at(order.node);
  OrderLane& others = orders_.at(order.node);
  if (order.effect != OrderEffect::Stops) return others.ask(std::move(order));
  LaneOrder again = order;
  again.call = [&own, order] {
    own.post(order);
    return DeskAnswer{};
  };
  // What was asked for before must not move the unit after it was stopped, whichever node moves it.
  for (auto& [node, orders] : orders_) orders.dropMoves(again);
  return own.ask(std::move(order));
}

}  // namespace lamina
