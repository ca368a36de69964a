// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, CellControllerSettings& settings) {
  describe(schema, settings.machine, "Machine that programs are checked for as they are put into the queue.");
  schema.text(
      "journal.folder", settings.folder,
      "Folder of the journal and of the jobs' files, on a local disk; a relative one is in the folder "
      "that the node runs in.");
  schema.number("journal.least_free_gib", settings.care.least_free_gib, {0.0, 1e6},
                "Room on the journal's disk below which alarm 7002 warns; jobs are refused below 1 GiB.");
  schema.integer("journal.copy_hour", settings.care.copies.hour, {-1, 23},
                 "Hour of the day, UTC, from which on the journal is copied once a day; -1 for no copies.");
  schema.integer("journal.copies_kept", settings.care.copies.kept, {1, 1000},
                 "Copies that are kept, the last ones.");
  schema.text(
      "corrections.folder", settings.corrections_folder,
      "Folder in which gcode_streamer records the maps that it applies (its corrections.folder), on this "
      "host: they are kept with the record of each part. Empty for none.");
  schema.choice<ExecutorKind>(
      "executor.kind", settings.executor,
      {{"stream", ExecutorKind::Stream}, {"driver", ExecutorKind::Driver}},
      "Node that runs the jobs: gcode_streamer, whose jobs are programs of G-code, or trajectory_driver, "
      "whose jobs are toolpaths (.csv).");
  schema.choice<Placement>(
      "executor.placement", settings.placement, {{"centre", Placement::Centre}, {"as_is", Placement::AsIs}},
      "Where toolpaths stand: over the middle of the bed, or where their coordinates say.");
  describe(schema, settings.drive.joints);
  describe(schema, settings.drive.clearance);
  schema.number("executor.patience_s", settings.patience_s, {0.1, 60.0},
                "Time in which the executor answers: at the start of the node, and each order.");
  schema.flag(
      "packml.hold_anywhere", settings.is_held_on_the_way,
      "Whether Hold is accepted in Starting, Unholding, Suspending, Suspended and Unsuspending, too.");
  schema.choice(
      "queue.advance", settings.advance, {{"ask", QueueAdvance::Ask}, {"automatic", QueueAdvance::Automatic}},
      "What begins the next job of the queue after a part: a person or the PLC, or the queue itself "
      "once the part was taken away.");
  schema.flag(
      "start.local_after_estop", settings.is_start_local_after_stop,
      "Whether the first Start after the PLC has reported the emergency stop has to come from somebody else "
      "than the PLC.");
  schema.flag("start.needs_loop", settings.needs_loop,
              "Whether jobs run with the height loop: Start is refused while height_controller is blocked or "
              "says nothing, and while the clocks of the hosts are apart (alarm 8003).");
  schema.flag("plc.required", settings.plc.is_required,
              "Whether the unit starts and runs only beside a PLC that gives its interlocks.");
  schema.flag("plc.unsuspends", settings.plc.unsuspends,
              "Whether the unit goes on by itself when the PLC's reason for which it was suspended is gone.");
  schema.number("plc.patience_s", settings.plc.patience_s, {1.0, 600.0},
                "Time for which a PLC that is required may be silent while the unit runs, such as the link "
                "after a restart.");
}

bool demandsLocalStart(const PlcAlarm& alarm, const CellControllerSettings& settings) {
  constexpr int kEmergencyStop = 1207;
  return alarm.id == kEmergencyStop && settings.is_start_local_after_stop;
}

}  // namespace lamina
