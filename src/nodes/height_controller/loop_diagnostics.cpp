// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "loop_diagnostics.hpp"

namespace lamina {
namespace {

void addClouds(const FeedCounts& feed, const LoopCounts& loop,
               diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.add("clouds received", feed.received);
  status.add("clouds placed", feed.placed);
  status.add("clouds waiting for tf", feed.waiting);
  status.add("clouds without frame or stamp", feed.without_frame);
  status.add("clouds of sensors without time offset", feed.without_offset);
  status.add("last sensor without time offset", feed.last_without_offset);
  status.add("clouds malformed", feed.malformed);
  status.add("last malformed cloud", feed.last_fault);
  status.add("clouds without transform", feed.without_transform);
  status.add("clouds pushed out", feed.pushed_out);
  status.add("clouds of the print before", feed.of_former_print);
  status.add("clouds waiting for older ones", loop.clouds_waiting);
  status.add("clouds read", loop.clouds_read);
  status.add("clouds late", loop.clouds_late);
  status.add("clouds of a stuck sensor", loop.clouds_stuck);
}

void addPoints(const PointCounts& points, diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.add("points received", points.received);
  status.add("points used", points.used);
  status.add("points trimmed off profiles", points.trimmed);
  status.add("points not finite or zero", points.not_finite);
  status.add("points outside the sensor's window", points.outside_window);
  status.add("points off their neighbours", points.spray);
  status.add("points on no deposited cell", points.off_path);
  status.add("points at a grazing angle", points.grazing);
  status.add("points beside a crown", points.beside_crown);
  status.add("points mirrored", points.mirrored);
}

}  // namespace

void addCounts(const FeedCounts& feed, const LoopCounts& loop,
               diagnostic_updater::DiagnosticStatusWrapper& status) {
  addClouds(feed, loop, status);
  status.add("readings used", loop.readings_used);
  status.add("readings contested", loop.readings_contested);
  status.add("readings believed", loop.readings_believed);
  status.add("readings of layers that are done", loop.readings_below);
  status.add("further maps not used", loop.trims_refused);
  addPoints(loop.points, status);
}

}  // namespace lamina
