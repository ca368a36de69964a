// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// What a person says of a part.
struct PartJudgement {
  std::int64_t job = 0;  ///< its last part; 0: the part made last
  std::string verdict;   ///< "good", "scrap" or "rework"
  std::string by;
  std::string reason;
  double time_s = 0.0;  ///< since 1970, UTC
};

/// A part whose verdict was changed.
struct JudgedPart {
  std::string serial;
  std::string before;  ///< its verdict until then
};

/// Changes the verdict of a part, in the journal, its record and the audit: all of it or nothing. The rest of
/// the record stays.
/// @throws InvalidInput if there is no such verdict, nobody judges, or there is no such part
JudgedPart judgePart(CellJournal& journal, ArtefactStore& store, const PartJudgement& judgement);

/// Writes the record of an execution anew, with what the journal has learnt since, such as a scan of its last
/// layer; its verdict and the maps that it names stay. Does nothing if it has no part.
void renewRecord(CellJournal& journal, ArtefactStore& store, std::int64_t execution, double time_s);

}  // namespace lamina
