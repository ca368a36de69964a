// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/nozzle_intake.hpp"

#include <utility>

namespace lamina {
namespace {

constexpr double kTurn = 0.02;  // s between looks at what is due

}  // namespace

NozzleIntake::NozzleIntake(const ros::NodeHandle& node, Receiver receiver)
    : transforms_(sequence_, node), receiver_(std::move(receiver)) {
  timer_ = node.createWallTimer(ros::WallDuration(kTurn), [this](const ros::WallTimerEvent&) { passDue(); });
}

void NozzleIntake::passDue() {
  // Stamp by stamp, so that none is far behind the latest that the buffer has.
  do {
    for (const StampedNozzle& nozzle : sequence_.takeNozzles()) receiver_(nozzle.bed_from_nozzle);
  } while (sequence_.passNext());
}

}  // namespace lamina
