// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/node_lanes.hpp"

#include <utility>

namespace lamina {

NodeLanes::NodeLanes(const std::vector<std::string>& nodes) {
  for (const std::string& node : nodes) lanes_.try_emplace(node);
}

DeskAnswer NodeLanes::give(LaneOrder order) {
  Lanes& lanes = lanes_.at(order.node);
  if (order.effect != OrderEffect::Stops) return lanes.orders.ask(std::move(order));
  // What was asked for before must not move the unit after it was stopped, whichever node moves it.
  for (auto& [node, other] : lanes_) other.orders.dropMoves(order);
  return lanes.stops.ask(std::move(order));
}

}  // namespace lamina
