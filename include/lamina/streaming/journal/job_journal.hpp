// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "lamina/streaming/journal/job_progress.hpp"

namespace lamina {

/// Where the progress of a job is kept, and the job that is gone on with.
struct StreamJournal {
  std::string path;                              ///< of the progress file; empty for none
  std::optional<JournalledProgress> unfinished;  ///< nothing to begin anew
};

/// The progress file of a port, as `stream.journal` says: its path; empty for none; for `auto`, a file of the
/// port's name in `lamina` in the user's folder for what programs remember ($XDG_STATE_HOME, or else
/// ~/.local/state).
/// @throws InvalidConfig if there is no such folder
std::string journalPath(const StreamSettings& settings, const std::string& port);

/// Begins a progress file at that path. A folder that is missing is made, for its owner alone.
/// @throws FileError if nothing can be written there
StreamJournal beginJournal(const std::string& path);

/// Copies the progress file of a job that did not complete to `path` + ".before", so that what is known of it
/// outlives the next job. Nothing is done where there is no progress file, or one that cannot be read.
/// @throws FileError if nothing can be written there
void keepUnfinished(const std::string& path);

/// Reads what is known of the last job at a port.
/// @throws FileError if there is no progress file, or it is damaged
JournalledProgress readJournal(const std::string& path);

/// Goes on with the job that a progress file tells of.
/// @throws FileError as `readJournal`
/// @throws InvalidProgram if it is another program, naming what differs
/// @throws InvalidInput if the port is another, the job has ended by itself, or it was corrected by other
///   maps, naming the first that differs
StreamJournal resumeJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// Follows the print that a print server runs by itself. What the progress file tells of it is in
/// `unfinished`, if it tells of this program at this port: the machine itself knows what it prints.
/// @throws FileError as `beginJournal`
StreamJournal followJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// What a program and its port say of a job, before the machine is known.
/// @throws FileError if the program is gone
JournalledJob describedJob(const StreamableProgram& program, const std::string& port);

/// The same with the time it is.
JobProgress stampedNow(JobProgress progress);

/// 64 hexadecimal digits over all bytes of the program, comments too.
/// @throws FileError if the file is gone
std::string sha256Of(const StreamableProgram& program);

/// What is known, for a person: state and time, the last line certainly taken, the lines in doubt, the layer.
std::string describeProgress(const JournalledProgress& known);

}  // namespace lamina
