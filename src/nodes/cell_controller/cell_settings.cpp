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
  schema.number("executor.patience_s", settings.patience_s, {0.1, 60.0},
                "Time in which the executor answers: at the start of the node, and each order.");
  schema.flag("packml.hold_anywhere", settings.is_held_on_the_way,
              "Whether Hold is accepted in Starting, Unholding, Suspending, Suspended and Unsuspending, too; "
              "gcode_streamer pauses a job that runs, and no other.");
}

}  // namespace lamina
