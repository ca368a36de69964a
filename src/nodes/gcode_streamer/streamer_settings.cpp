// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streamer_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, StreamCorrectionSettings& settings) {
  schema.flag("corrections.use", settings.is_used,
              "Whether programs are corrected, layer by layer, by the maps on the topic correction.");
  schema.text("corrections.folder", settings.folder,
              "Folder for the maps that were applied and the record of them; empty for none.");
  schema.flag(
      "corrections.follow_plans", settings.follows_plans,
      "Whether the layers left are gone on with as planned anew (replanned_toolpath), in front of the "
      "layer that is waited for, where the job is of a toolpath.");
  schema.number("loop.wait_s", settings.loop.wait_s, {0.0, 600.0},
                "Time that the start of a layer waits for its corrections.");
  schema.text(
      "sensor.calibration", settings.calibration,
      "File that `lamina calibrate` wrote, for the feeder's dead time and lag where they are not stated; "
      "empty for none.");
  describeFeeding(schema, settings.loop);
}

void describe(SettingsSchema& schema, GcodeStreamerSettings& settings) {
  schema.text("port", settings.port.name,
              "Serial port or pseudo-terminal, tcp:host:port, or http://host:port of a print server.");
  schema.integer("baud", settings.port.baud, {50, 4000000}, "Baud rate of a serial port.");
  describe(schema, settings.machine, "Machine whose axes the reported positions belong to.");
  schema.text("executor.owner", settings.owner,
              "Node whose orders alone are followed, such as cell_controller; empty for anybody.");
  describe(schema, settings.stream);
  describe(schema, settings.program);
  describe(schema, settings.startup);
  describe(schema, settings.corrections);
  describe(schema, settings.dry);
  schema.number(
      "owner.grace_s", settings.owner_grace_s, {0.0, 3600.0},
      "Time without a word of the cell_controller that ordered the job, after which the job is held; "
      "0 for any time.");
  schema.text("guard.socket", settings.guard_socket,
              "Socket of the host_watch that stops the machine if this node dies or hangs; empty for none.");
}

}  // namespace lamina
