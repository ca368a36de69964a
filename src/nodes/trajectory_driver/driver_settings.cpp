// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, DriverSettings& settings) {
  describe(schema, settings.machine, "Machine or robot that is driven.");
  schema.text("executor.owner", settings.owner,
              "Node whose orders alone are followed, such as cell_controller; empty for anybody.");
  schema.number("owner.grace_s", settings.owner_grace_s, {0.0, 3600.0},
                "Time without a word of the cell_controller that ordered the job, after which the job is "
                "held; 0 for any time.");
  schema.text(
      "guard.socket", settings.guard_socket,
      "Socket of the host_watch that stops the controller if this node dies or hangs; empty for none.");
  describe(schema, settings.run);
  describe(schema, settings.feeder);
  schema.flag("check_clearance", settings.is_clearance_checked,
              "Refuse a toolpath whose links run into bed, part or each other.");
  describe(schema, settings.clearance);
  schema.number(
      "tracking.tip_mm", settings.tracking.tip_mm, {0.0, 1e3},
      "Error of the nozzle tip that aborts the job, ten times that on the way to its start; 0 for no limit.");
  schema.number("tracking.silence_s", settings.tracking.silence_s, Bounds::above(0.0, 60.0),
                "Time without a report of the controller that aborts the job.");
  schema.choice<SilenceBy>("tracking.silence_by", settings.tracking.silence_by,
                           {{"arrival", SilenceBy::Arrival}, {"stamps", SilenceBy::Stamps}},
                           "Clock of that silence: the arrival of reports, or their stamps.");
  describe(schema, settings.approach);
  describe(schema, settings.resume);
  schema.flag("process_io.required", settings.process_io.is_required,
              "Whether a job needs process_io: it begins once that is ready, and is held when it is not.");
  schema.number("process_io.silence_s", settings.process_io.silence_s, Bounds::above(0.0, 60.0),
                "Time without word of process_io that holds the job.");
  describe(schema, settings.dry);
  describe(schema, settings.jog);
  schema.flag("corrections.use", settings.is_corrected,
              "Whether what is not handed over yet is corrected by the maps on the topic correction.");
  schema.flag("corrections.follow_plans", settings.follows_plans,
              "Whether the job goes on with layers that are planned anew; only where it is corrected.");
  schema.text(
      "sensor.calibration", settings.calibration,
      "File that `lamina calibrate` wrote, for the feeder's dead time and lag where they are not stated; "
      "empty for none.");
  schema.number("loop.wait_s", settings.loop.wait_s, {0.0, 600.0},
                "Time that the start of a layer waits for its corrections.");
  describeFeeding(schema, settings.loop);
  schema.number("start_delay_s", settings.start_delay_s, {0.0, 60.0},
                "From the first chunk sent to the first motion.");
  schema.number("lift_mm", settings.lift_mm, {0.0, 1e3}, "How far the tool is lifted after an abort.");
  schema.number("lift_mm_s", settings.lift_mm_s, Bounds::above(0.0, 1e3), "Speed at which it is lifted.");
  schema.number("controller_wait_s", settings.controller_wait_s, {0.0, 600.0},
                "How long a job waits for its toolpath and the controller, and to hear of the joints and, by "
                "stamps, of it.");
}

}  // namespace lamina
