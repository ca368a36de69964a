// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// Stores the maps by which an execution was corrected, their record and their toolpath, from the folder to
/// which `gcode_streamer` writes them (`corrections.folder`).
/// @return the stored files; none if the folder's record belongs to another program, or was not written
///   during the execution
/// @throws FileError if a file cannot be read, or the store not written
std::vector<Artefact> keptCorrections(ArtefactStore& store, const std::string& folder, const QueuedJob& job,
                                      const ExecutionRow& execution);

}  // namespace lamina
