// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "profile_counts.hpp"

namespace lamina {
namespace {

CloudTally difference(const CloudTally& now, const CloudTally& then) {
  return {now.clouds - then.clouds, now.points - then.points};
}

CloudTally sum(const CloudTally& a, const CloudTally& b) {
  return {a.clouds + b.clouds, a.points + b.points};
}

}  // namespace

IntakeCounts since(const IntakeCounts& then, const IntakeCounts& now) {
  IntakeCounts counts = now;  // and what waits now
  counts.received = sum(difference(now.received, then.received), then.waiting);
  counts.placed = difference(now.placed, then.placed);
  counts.without_frame = difference(now.without_frame, then.without_frame);
  counts.malformed = difference(now.malformed, then.malformed);
  counts.without_transform = difference(now.without_transform, then.without_transform);
  counts.without_nozzle = difference(now.without_nozzle, then.without_nozzle);
  counts.pushed_out = difference(now.pushed_out, then.pushed_out);
  counts.of_former_print = difference(now.of_former_print, then.of_former_print);
  counts.lost = now.lost - then.lost;
  counts.points_not_finite = now.points_not_finite - then.points_not_finite;
  return counts;
}

lamina_msgs::ProfileCounts toMessage(const IntakeCounts& intake, const ProfileUse& use) {
  lamina_msgs::ProfileCounts message;
  message.received = intake.received.clouds;
  message.of_layers = use.of_layers.profiles;
  message.of_no_layer = use.of_no_layer.profiles;
  message.waiting = intake.waiting.clouds + use.waiting.profiles;
  message.without_frame = intake.without_frame.clouds;
  message.malformed = intake.malformed.clouds;
  message.without_transform = intake.without_transform.clouds;
  message.without_nozzle = intake.without_nozzle.clouds;
  message.pushed_out = intake.pushed_out.clouds;
  message.in_gap = use.in_gap.profiles;
  message.late = use.late.profiles;
  message.lost = intake.lost;
  message.points_received = intake.received.points;
  message.points_used = use.of_layers.points + use.of_no_layer.points - use.points_outside;
  message.points_outside = use.points_outside;
  message.points_not_finite = intake.points_not_finite;
  message.points_dropped = intake.without_frame.points + intake.malformed.points +
                           intake.without_transform.points + intake.without_nozzle.points +
                           intake.pushed_out.points + use.in_gap.points + use.late.points;
  message.points_waiting = intake.waiting.points + use.waiting.points;
  return message;
}

std::uint64_t unused(const lamina_msgs::ProfileCounts& counts) {
  return counts.without_frame + counts.malformed + counts.without_transform + counts.without_nozzle +
         counts.pushed_out + counts.in_gap + counts.late + counts.lost;
}

}  // namespace lamina
