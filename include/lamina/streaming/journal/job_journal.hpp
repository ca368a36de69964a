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

/// The progress file of a job, and the unfinished job that is to be resumed, if any.
struct StreamJournal {
  std::string path;                              ///< path of the progress file; empty for none
  std::optional<JournalledProgress> unfinished;  ///< job to resume; nothing for a job from its first line
  std::string execution = "";  ///< name that the client gave to this execution of a job; empty for none
};

/// Path of the progress file of a port by `stream.journal`; empty for none. With `auto` it is a file named
/// after the port in the folder `lamina` of the user's state folder ($XDG_STATE_HOME, or ~/.local/state).
/// @throws InvalidConfig if the setting is `auto` and the user's folders are unknown
std::string journalPath(const StreamSettings& settings, const std::string& port);

/// The journal of a job that begins, with its progress file at a path. Creates a missing folder, accessible
/// to its owner alone; the file is written when the job begins.
/// @throws FileError if no file can be written there
StreamJournal beginJournal(const std::string& path);

/// Copies the progress file of a job that did not complete to `path` + ".before", so that the next job does
/// not overwrite it, and adds its execution, if it has one, to the last thousand in `path` + ".executions".
/// Without effect if there is no progress file, or it cannot be read.
/// @throws FileError if the copy or the list cannot be written
void keepUnfinished(const std::string& path);

/// Reads the progress file of the last job at a port.
/// @throws FileError if there is no progress file, or it is damaged
JournalledProgress readJournal(const std::string& path);

/// State of an execution of a job by the progress file of its port.
enum class ExecutionRecord : std::uint8_t {
  None,  ///< unknown to the file: if this is the file of its port, no line of the execution was ever sent
  Unfinished,
  Complete,
};

/// Looks up an execution by its name in a progress file. A progress file is written before the first line is
/// sent.
/// @throws FileError if no progress file is kept, or it is damaged
/// @throws InvalidInput if another job was streamed at the port since the execution began
ExecutionRecord recordOf(const std::string& path, const std::string& execution);

/// The journal for resuming the job of a progress file.
/// @throws FileError as `readJournal`
/// @throws InvalidProgram naming the difference, if the job is that of another program
/// @throws InvalidInput if the job was at another port, is complete or was aborted, or was corrected
///   differently, naming the first correction map that differs
StreamJournal resumeJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// The journal for following a print that a print server runs by itself. `unfinished` is set if the progress
/// file is that of this program at this port. The file may be missing or damaged, since the machine itself
/// knows what it prints.
/// @throws FileError as `beginJournal`
StreamJournal followJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port);

/// The description of a job by its program and port; what only the machine knows is still empty.
/// @throws FileError if the program is gone
JournalledJob describedJob(const StreamableProgram& program, const std::string& port);

/// The progress with `time_ms` set to the present time.
JobProgress stampedNow(JobProgress progress);

/// SHA-256 of all bytes of the program, comments too, as 64 hexadecimal digits.
/// @throws FileError if the file is gone
std::string sha256Of(const StreamableProgram& program);

/// The progress in words: state and time, the last line that was certainly accepted, the layer, the lines in
/// doubt.
std::string describeProgress(const JournalledProgress& known);

}  // namespace lamina
