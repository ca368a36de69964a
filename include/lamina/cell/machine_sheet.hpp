// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// Kind of the artefact that holds the sheet of the machine for which a job's program was checked: lines of a
/// name, a colon, a space and a value.
constexpr char kMachineSheet[] = "machine";

/// A machine to which a job is bound.
struct BoundMachine {
  std::string name;
  std::string sheet;  ///< empty if it is not known; then the name alone counts
};

/// The differences between the machine and the one for which a job was checked, each a sentence with both
/// values; empty if there are none. A job of an older version has no sheet, and is bound to the name alone.
std::vector<std::string> machineDifferences(const QueuedJob& job, const BoundMachine& machine,
                                            const ArtefactStore& artefacts);

}  // namespace lamina
