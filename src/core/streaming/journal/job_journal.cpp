// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/journal/job_journal.hpp"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/percent_encoding.hpp"
#include "lamina/base/sha256.hpp"
#include "lamina/base/utc_time.hpp"

namespace lamina {
namespace {

constexpr const char* kAutoJournal = "auto";
constexpr const char* kBefore = ".before";          // of the job before that did not complete
constexpr const char* kExecutions = ".executions";  // of the jobs before that had one

/// A variable of the environment that holds an absolute path; empty if it holds none.
std::string folderFrom(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? value : "";
}

std::string stateFolder() {
  const std::string state = folderFrom("XDG_STATE_HOME");
  if (!state.empty()) return state + "/lamina";
  const std::string home = folderFrom("HOME");
  if (!home.empty()) return home + "/.local/state/lamina";
  const passwd* const user = ::getpwuid(::getuid());
  if (user != nullptr && user->pw_dir != nullptr) return std::string(user->pw_dir) + "/.local/state/lamina";
  throw InvalidConfig(
      "stream.journal is auto, but neither XDG_STATE_HOME nor HOME is set, and the user has no folder; "
      "expected "
      "one of them, the path of a file, or nothing for no journal");
}

/// A file name that no other port has: "/dev/ttyUSB0" becomes "dev+ttyUSB0".
std::string fileNameOf(const std::string& port) {
  const bool is_path = port.compare(0, 4, "tcp:") != 0 && port.compare(0, 5, "http:") != 0;
  const std::string whole =
      is_path ? std::filesystem::absolute(port).lexically_normal().string().substr(1) : port;
  std::string name = percentEncoded(whole, "-_./");
  std::replace(name.begin(), name.end(), '/', '+');
  return name + ".progress";
}

/// The executions before the last one, one on each line, oldest first.
std::vector<std::string> executionsBefore(const std::string& path) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(path + kExecutions)) return names;
  std::istringstream text(readFile(path + kExecutions));
  for (std::string name; std::getline(text, name);) names.push_back(name);
  return names;
}

std::string nameInList(const std::string& execution) { return percentEncoded(execution, "-_./:"); }

/// Makes known that an execution has begun, for as long as no thousand others have after it.
void noteExecution(const std::string& path, const std::string& execution) {
  constexpr std::size_t kMost = 1000;
  if (execution.empty()) return;
  const std::string name = nameInList(execution);
  const std::vector<std::string> names = executionsBefore(path);
  if (!names.empty() && names.back() == name) return;
  std::string text;
  for (std::size_t i = names.size() < kMost ? 0 : names.size() - kMost + 1; i < names.size(); ++i)
    text += names[i] + "\n";
  writeDurably(path + kExecutions, text + name + "\n");
}

/// Makes a folder and those above it, for their owner alone.
void makeFolder(const std::filesystem::path& folder) {
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  makeFolder(folder.parent_path());
  if (::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST) return;
  throw FileError("cannot make the folder " + folder.string() +
                  " for the progress file: " + std::strerror(errno));
}

std::string mapText(const AppliedMap& map) {
  return "layer " + std::to_string(map.layer) + " by map " + map.digest;
}

std::string mapCountText(const ProgramOrigin& origin) {
  const std::size_t count = origin.maps.size();
  return std::to_string(count) + (count == 1 ? " correction map" : " correction maps");
}

/// The first map that differs, in words; empty if none does.
std::string differenceOf(const ProgramOrigin& known, const ProgramOrigin& given) {
  const std::size_t most = std::max(known.maps.size(), given.maps.size());
  for (std::size_t i = 0; i < most; ++i) {
    if (i < known.maps.size() && i < given.maps.size() && known.maps[i] == given.maps[i]) continue;
    return "given is " + (i < given.maps.size() ? mapText(given.maps[i]) : std::string("no further map")) +
           "; the job to go on with lays " +
           (i < known.maps.size() ? mapText(known.maps[i]) : std::string("no further layer by a map"));
  }
  return {};
}

/// The corrections of what was deposited must be those of the rest.
/// @throws InvalidInput if the job was corrected otherwise
void requireSameCorrections(const JournalledJob& job, const StreamableProgram& program,
                            const std::string& what_is_known) {
  const std::optional<ProgramOrigin>& given = program.origin();
  if (!job.origin && !given) return;
  if (!job.origin)
    throw InvalidInput("corrections are given; the job to go on with has none" + what_is_known);
  if (!given)
    throw InvalidInput("no corrections are given; the job to go on with was corrected by " +
                       mapCountText(*job.origin) + ": expected the same" + what_is_known);
  if (given->program_sha256 != job.origin->program_sha256) return;  // another program: refused as such
  const std::string difference = differenceOf(*job.origin, *given);
  if (!difference.empty()) throw InvalidInput(difference + what_is_known);
}

/// A job that was corrected on its way is gone on with by what its record says.
/// @return the same job as one of the program that the record makes
/// @throws InvalidInput if the program is not made by that record, or by other settings
JournalledProgress asRecorded(JournalledProgress known, const StreamableProgram& program,
                              const std::string& port, const std::string& what_is_known) {
  const RevisionRecord recorded = known.job.revision.value_or(RevisionRecord());
  const std::optional<ProgramOrigin>& given = program.origin();
  if (!given || !given->record)
    throw InvalidInput("no recorded corrections are given; the job to go on with is recorded in " +
                       recorded.folder + what_is_known);
  if (given->record->job != recorded.job)
    throw InvalidInput("the corrections in " + given->record->folder + " are of job '" + given->record->job +
                       "'; the job to go on with is '" + recorded.job + "', recorded in " + recorded.folder +
                       what_is_known);
  if (given->program_sha256 != known.job.program_sha256)
    throw InvalidProgram(program.name() + " has the SHA-256 " + given->program_sha256.substr(0, 12) +
                         "...; the job to go on with has " + known.job.program_sha256.substr(0, 12) + "..." +
                         what_is_known);
  if (given->record->settings != recorded.settings)
    throw InvalidInput("corrected is with " + given->record->settings + "; the job to go on with was with " +
                       recorded.settings + what_is_known);
  JournalledJob job = describedJob(program, port);
  job.protocol = known.job.protocol;
  job.firmware_name = known.job.firmware_name;
  job.line_base = known.job.line_base;
  job.execution = known.job.execution;
  known.progress.sent_through = std::min(known.progress.sent_through, job.lines_total);
  if (known.progress.taken_through > known.progress.sent_through)
    throw InvalidInput("the record makes a program of " + std::to_string(job.lines_total) +
                       " lines, fewer than were taken" + what_is_known);
  known.job = std::move(job);
  return known;
}

/// What is known of a program, and what else may differ of a corrected one.
std::string otherProgramText(const JournalledJob& job, const StreamableProgram& program) {
  const bool is_same_base =
      job.origin && program.origin() && job.origin->program_sha256 == program.origin()->program_sha256;
  return is_same_base ? "the same program by the same maps, but corrected with other settings (loop.*)"
                      : "it is another program, or was changed";
}

}  // namespace

std::string journalPath(const StreamSettings& settings, const std::string& port) {
  if (settings.journal != kAutoJournal) return settings.journal;
  return stateFolder() + "/" + fileNameOf(port);
}

StreamJournal beginJournal(const std::string& path) {
  if (path.empty()) return {};
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  makeFolder(folder);
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw FileError("cannot keep the progress file " + path + ": " + std::strerror(errno));
  return {path, {}};
}

void keepUnfinished(const std::string& path) {
  JournalledProgress known;
  try {
    if (!std::filesystem::exists(path)) return;
    known = readJournal(path);
  } catch (const FileError&) {
    return;
  }
  noteExecution(path, known.job.execution);
  if (known.progress.state != PackmlState::Complete) writeDurably(path + kBefore, readFile(path));
}

JournalledProgress readJournal(const std::string& path) {
  if (path.empty()) throw FileError("no progress file is kept: stream.journal is empty");
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && !unknown)
    throw FileError("no job is known of this port: there is no progress file '" + path +
                    "'; expected that of the user and the port that the job was begun with");
  return decodeJournal(readFile(path), path);
}

ExecutionRecord recordOf(const std::string& path, const std::string& execution) {
  if (path.empty())
    throw FileError("execution " + execution +
                    " cannot be looked for: no progress file is kept, since stream.journal is empty");
  const std::string before = path + kBefore;
  if (std::filesystem::exists(path)) {
    const JournalledProgress known = readJournal(path);
    if (known.job.execution == execution)
      return known.progress.state == PackmlState::Complete ? ExecutionRecord::Complete
                                                           : ExecutionRecord::Unfinished;
  }
  if (std::filesystem::exists(before)) {
    const JournalledProgress known = readJournal(before);
    if (known.job.execution == execution)
      throw InvalidInput("another job was streamed since execution " + execution +
                         " was cut off, so that it cannot just go on; known is: " + describeProgress(known));
  }
  const std::vector<std::string> names = executionsBefore(path);
  if (std::find(names.begin(), names.end(), nameInList(execution)) != names.end())
    throw InvalidInput("execution " + execution +
                       " has begun before, and other jobs were streamed since, so that it can neither go on "
                       "nor begin; expected a new execution");
  return ExecutionRecord::None;
}

StreamJournal resumeJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port) {
  const JournalledProgress known = readJournal(path);
  const std::string what_is_known = "; known is: " + describeProgress(known);
  if (known.progress.state == PackmlState::Complete)
    throw InvalidInput("there is nothing to go on with" + what_is_known);
  if (known.progress.state == PackmlState::Aborted || known.progress.state == PackmlState::Aborting)
    throw InvalidInput(
        "the job was stopped, and its machine with it, so that it cannot just go on; lamina resume makes a "
        "program of the rest" +
        what_is_known);
  if (known.job.port != port)
    throw InvalidInput("the port is " + port + "; the job to go on with was at " + known.job.port +
                       what_is_known);
  if (known.job.revision) return {path, asRecorded(known, program, port, what_is_known)};
  requireSameCorrections(known.job, program, what_is_known);
  const std::string digest = sha256Of(program);
  if (known.job.program_sha256 != digest || known.job.lines_total != program.lines())
    throw InvalidProgram(program.name() + " has the SHA-256 " + digest.substr(0, 12) +
                         "...; the job to go on with has " + known.job.program_sha256.substr(0, 12) +
                         "...: " + otherProgramText(known.job, program) + what_is_known);
  return {path, known};
}

StreamJournal followJournal(const std::string& path, const StreamableProgram& program,
                            const std::string& port) {
  StreamJournal journal = beginJournal(path);
  if (path.empty() || !std::filesystem::exists(path)) return journal;
  try {
    JournalledProgress known = readJournal(path);
    const bool is_same = known.job.port == port && known.job.lines_total == program.lines() &&
                         known.job.program_sha256 == sha256Of(program);
    if (is_same) journal.unfinished = std::move(known);
  } catch (const FileError&) {
    journal.unfinished.reset();  // a damaged file states nothing, and the machine is asked all the same
  }
  return journal;
}

JournalledJob describedJob(const StreamableProgram& program, const std::string& port) {
  JournalledJob job;
  std::error_code error;
  const auto path = std::filesystem::canonical(program.name(), error);
  job.program = error ? program.name() : path.string();
  const auto text = program.openText();
  text->seekg(0, std::ios::end);
  job.program_bytes = static_cast<std::uint64_t>(std::max<std::streamoff>(text->tellg(), 0));
  job.program_sha256 = sha256Of(program);
  job.port = port;
  job.lines_total = program.lines();
  job.origin = program.origin();
  return job;
}

JobProgress stampedNow(JobProgress progress) {
  progress.time_ms = std::chrono::duration_cast<std::chrono::milliseconds>(
                         std::chrono::system_clock::now().time_since_epoch())
                         .count();
  return progress;
}

std::string sha256Of(const StreamableProgram& program) {
  const auto text = program.openText();
  return sha256Of([&text](char* buffer, std::size_t size) {
    text->read(buffer, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(text->gcount());
  });
}

std::string describeProgress(const JournalledProgress& known) {
  const JobProgress& progress = known.progress;
  const std::string total = std::to_string(known.job.lines_total);
  const std::string line = std::to_string(progress.taken_through);
  const std::string when = std::string(", ") + toString(progress.state) + " at " +
                           utcText(static_cast<double>(progress.time_ms) / 1000.0, "%Y-%m-%d %H:%M:%S UTC");
  std::string text = known.job.program + " at " + known.job.port;
  if (known.job.revision)
    text += ", corrected on its way as recorded in " + known.job.revision->folder;
  else if (known.job.origin)
    text += ", corrected by " + mapCountText(*known.job.origin);
  if (!known.job.uploaded_as.empty()) {
    text += ", uploaded as " + known.job.uploaded_as + when + ": the machine had read line " + line + " of " +
            total;
    if (progress.layer >= 0) text += ", in layer " + std::to_string(progress.layer);
    return text + (isFinal(progress.state) ? "" : "; it prints on by itself, so that it may be further");
  }
  text += when + ": line " + line + " of " + total + " was certainly taken";
  if (progress.layer >= 0) text += ", in layer " + std::to_string(progress.layer);
  if (progress.sent_through > progress.taken_through && progress.state != PackmlState::Complete)
    text += "; lines " + std::to_string(progress.taken_through + 1) + " to " +
            std::to_string(progress.sent_through) + " are in doubt";
  return text;
}

}  // namespace lamina
