// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lamina/streaming/job/stream_settings.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "lamina/streaming/journal/job_progress.hpp"

namespace lamina {

/// The progress file of a job, and the job that is to be resumed.
struct StreamJournal {
  std::string path;                              ///< of the progress file; empty for none
  std::optional<JournalledProgress> unfinished;  ///< job to resume; none to begin anew
  std::string execution = "";  ///< name of the execution that begins, as whoever ordered it knows it
};

/// Path of the progress file of a port by `stream.journal`; empty for none. For `auto` it is a file with the
/// name of the port in the folder `lamina` of the user's state folder ($XDG_STATE_HOME, or ~/.local/state).
/// @throws InvalidConfig if there is no such folder
std::string journalPath(const StreamSettings& settings, const std::string& port);

/// Begins a progress file at that path. A missing folder is created, accessible to its owner alone.
/// @throws FileError if nothing can be written there
StreamJournal beginJournal(const std::string& path);

/// Copies the progress file of a job that did not complete to `path` + ".before", so that it outlives the
/// next job. Without effect if there is no progress file, or one that cannot be read.
/// @throws FileError if nothing can be written there
void keepUnfinished(const std::string& path);

/// Reads a progress file: the last job at a port.
/// @throws FileError if there is no progress file, or it is damaged
JournalledProgress readJournal(const std::string& path);

/// How far an execution of a job is, as the progress file of its port knows it.
enum class ExecutionRecord : std::uint8_t {
  None,  ///< no line of it has left, as long as the file is the one of its port
  Unfinished,
  Complete,
};

/// Looks for an execution by its name in a progress file, which is written before the first line leaves.
/// @throws FileError if no progress file is kept, or it is damaged
/// @throws InvalidInput if another job was streamed at the port since the execution was cut off
ExecutionRecord recordOf(const std::string& path, const std::string& execution);

/// The journal that resumes the job of a progress file.
/// @throws FileError as `readJournal`
/// @throws InvalidProgram if the job is that of another program, naming the difference
/// @throws InvalidInput if the job is that of another port, has ended by itself, or was corrected by other
///   maps, naming the first that differs
StreamJournal resumeJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// The journal that follows a print which a print server runs by itself. `unfinished` is set if the progress
/// file is that of this program at this port; it may be missing, since the machine itself knows what it
/// prints.
/// @throws FileError as `beginJournal`
StreamJournal followJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// The description of a job by its program and port, before the machine is known.
/// @throws FileError if the program is gone
JournalledJob describedJob(const StreamableProgram& program, const std::string& port);

/// The progress with the present time.
JobProgress stampedNow(JobProgress progress);

/// SHA-256 of all bytes of the program, comments too, as 64 hexadecimal digits.
/// @throws FileError if the file is gone
std::string sha256Of(const StreamableProgram& program);

/// The progress in words: state and time, the last line certainly taken, the lines in doubt, the layer.
std::string describeProgress(const JournalledProgress& known);

}  // namespace lamina
