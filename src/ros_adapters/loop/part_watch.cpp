// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop/part_watch.hpp"

namespace lamina {

using State = lamina_msgs::MachineState;

bool isUnderWay(const State& machine) {
  return machine.state == State::STARTING || machine.state == State::EXECUTE;
}

bool isEnd(const State& machine) {
  return machine.state == State::COMPLETE || machine.state == State::ABORTED ||
         machine.state == State::STOPPED;
}

bool PartWatch::see(const State& machine, std::size_t layer) {
  if (isEnd(machine)) {
    if (has_run_) end_ = {machine.state, machine.layer};
    return false;
  }
  has_run_ = true;
  if (!end_ || !isUnderWay(machine)) return false;
  // Where nothing of the machine says so, the nozzle may be at the next layer.
  const auto at = static_cast<std::int64_t>(machine.layer);
  const auto seen = static_cast<std::int64_t>(layer);
  const bool is_below = at >= 0 && at < seen && (at + 1 < seen || machine.layer < end_->layer);
  const bool begins = end_->state == State::COMPLETE || is_below;
  if (begins || at >= 0) end_.reset();  // if it does not begin, it goes on
  return begins;
}

}  // namespace lamina
