// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "height_controller_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, HeightControllerSettings& settings) {
  describe(schema, settings.run);
  schema.text("output_folder", settings.output_folder,
              "Where reports and figures of each print are saved; empty saves nothing.");
  schema.number("queue_mb", settings.queue_mb, Bounds::above(0.0, 1e6),
                "Memory of the clouds that may wait for tf; with more, the oldest are pushed out.");
  schema.number("arrival_hold_s", settings.arrival_hold_s, {0.0, 10.0},
                "Real time for which tf waits for clouds that were sent with it and come later.");
  schema.text(
      "memory_file", settings.memory_file,
      "File that keeps what the loop knows after each layer, for a restarted node to go on from; empty "
      "keeps nothing.");
  schema.flag("pauses_print", settings.pauses_print,
              "Whether alarms that hold the print call the service pause.");
  schema.flag(
      "plans_followed", settings.plans_followed,
      "Whether the executor goes on with layers planned anew by itself: they get no map and do not hold "
      "the print.");
}

bool holdsPrint(const RaisedAlarm& alarm, const HeightControllerSettings& settings) {
  // A plan takes the place of layers that must not be begun before.
  const bool is_planned = alarm.reaction == LoopReaction::Replan && !settings.plans_followed;
  return settings.pauses_print && (alarm.reaction == LoopReaction::Hold || is_planned);
}

}  // namespace lamina
