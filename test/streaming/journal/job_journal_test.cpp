// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/journal/job_journal.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <future>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "streaming/journal/journal_writer.hpp"
#include "streaming/journal/progress_file.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

StreamableProgram journalled(const std::string& text) { return StreamableProgram::fromText("part", text); }

JournalledJob jobOf(const StreamableProgram& program) {
  JournalledJob job;
  job.program = program.name();
  job.program_sha256 = sha256Of(program);
  job.port = "/dev/printer";
  job.protocol = "marlin";
  job.lines_total = program.lines();
  job.line_base = 2'000'000;
  return job;
}

StreamStatus statusAt(std::uint64_t sent, std::uint64_t taken) {
  StreamStatus status;
  status.state = PackmlState::Execute;
  status.lines_sent = sent;
  status.lines_acknowledged = taken;
  return status;
}

TEST(JobJournal, DigestsTheBytesOfAProgram) {
  // The digest of "G28" by sha256sum of GNU coreutils.
  EXPECT_EQ(sha256Of(journalled("G28")), "f3bfcb90d1ca0282a1cb6d92840f62cf518698cac0fa47cce82950da1b566b3a");
}

TEST(JobJournal, LiesInTheUsersFolderUnderTheNameOfThePort) {
  ::setenv("XDG_STATE_HOME", "/state", 1);
  EXPECT_EQ(journalPath({}, "/dev/ttyUSB0"), "/state/lamina/dev+ttyUSB0.progress");
  EXPECT_EQ(journalPath({}, "tcp:printer.local:23"), "/state/lamina/tcp%3Aprinter.local%3A23.progress");
  EXPECT_EQ(journalPath({}, "http://printer:7125"), "/state/lamina/http%3A++printer%3A7125.progress");
  EXPECT_NE(journalPath({}, "/dev/a/b"), journalPath({}, "/dev/a+b"));
  ::unsetenv("XDG_STATE_HOME");
  StreamSettings settings;
  settings.journal = "";
  EXPECT_EQ(journalPath(settings, "/dev/ttyUSB0"), "");
  settings.journal = "/some/where";
  EXPECT_EQ(journalPath(settings, "/dev/ttyUSB0"), "/some/where");
}

TEST(JobJournal, MakesAFolderForItsOwnerAlone) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("state/lamina/port.progress");
  EXPECT_EQ(beginJournal(path).path, path);
  struct stat about {};
  ASSERT_EQ(::stat((folder.file("state/lamina")).c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 07777U, 0700U);
  EXPECT_EQ(beginJournal("").path, "");
  EXPECT_THROW(beginJournal("/proc/nowhere/port.progress"), FileError);
}

TEST(JobJournal, SaysThatAPortHasHadNoJob) {
  const test::ScratchFolder folder;
  try {
    readJournal(folder.file("none.progress"));
    ADD_FAILURE() << "there is none";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find("no job is known of this port: there is no progress file '"), 0U)
        << error.what();
  }
}

TEST(JobJournal, KnowsOfEveryLineBeforeItLeaves) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "G28\n";
  const auto program = journalled(text);
  JobProgress start;
  start.sent_through = 256;
  JournalWriter writer(fileWriter({path, {}}, jobOf(program)), start, program.lines(), kLongestWrite);
  double now = 0.0;
  for (std::uint64_t sent = 1; sent <= 10000; sent += 97) {
    writer.record(statusAt(sent, sent - 1), now += 0.001);
    const JobProgress known = readJournal(path).progress;
    EXPECT_GE(known.sent_through, sent);
    EXPECT_LE(known.taken_through + 8, std::max<std::uint64_t>(sent - 1, 8)) << "eight oks may be others'";
    EXPECT_LE(known.sent_through, 10000U);
  }
}

TEST(JobJournal, IsGivenUpIfTheDiskDoesNotAnswer) {
  std::promise<void> disk;
  JobProgress start;
  start.sent_through = 256;
  const SteadyClock clock;
  const double begin_s = clock.now();
  {
    JournalWriter writer([answers = disk.get_future().share()](const JobProgress&) { answers.wait(); }, start,
                         10000, 0.05);
    EXPECT_THROW(writer.record(statusAt(100, 90), 0.0), FileError) << "the file is not there yet";
    writer.record(statusAt(10000, 9000), 0.2);  // the job goes on
  }
  EXPECT_LT(clock.now() - begin_s, 30.0) << "the disk is not waited for";
  disk.set_value();
}

TEST(JobJournal, KeepsWhatWasKnownOfAJobThatDidNotComplete) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const StreamableProgram program = journalled("G28\nG1 X1\nG1 X2\n");
  const auto write = [&](PackmlState state, std::uint64_t taken) {
    JobProgress known;
    known.taken_through = known.sent_through = taken;
    known.state = state;
    static_cast<void>(ProgressFile(path, jobOf(program), known));
    keepUnfinished(path);
  };
  keepUnfinished(path);
  EXPECT_THROW(readFile(path + ".before"), FileError) << "there was no job";
  write(PackmlState::Execute, 2);
  EXPECT_EQ(readJournal(path + ".before").progress.taken_through, 2U);
  write(PackmlState::Complete, 3);
  EXPECT_EQ(readJournal(path + ".before").progress.taken_through, 2U);
  writeFile(path, "no progress file");
  keepUnfinished(path);
  EXPECT_EQ(readJournal(path + ".before").progress.taken_through, 2U);
}

TEST(JobJournal, KnowsEveryExecutionThatHasBegun) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto execute = [&](const std::string& execution, PackmlState end) {
    JournalledJob job = jobOf(journalled("G28\n"));
    job.execution = execution;
    JobProgress known;
    known.state = end;
    keepUnfinished(path);
    static_cast<void>(ProgressFile(path, job, known));
  };
  EXPECT_EQ(recordOf(path, "first"), ExecutionRecord::None);
  execute("first", PackmlState::Execute);
  EXPECT_EQ(recordOf(path, "first"), ExecutionRecord::Unfinished);
  execute("second\none", PackmlState::Complete);
  execute("third", PackmlState::Execute);
  execute("", PackmlState::Execute);
  execute("", PackmlState::Execute);
  for (const char* begun : {"first", "second\none", "third"})
    EXPECT_THROW(recordOf(path, begun), InvalidInput) << begun;
  EXPECT_EQ(recordOf(path, "one"), ExecutionRecord::None);
  EXPECT_EQ(recordOf(path, "fourth"), ExecutionRecord::None);
}

TEST(JobJournal, KeepsTheEndOfAJob) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto program = journalled("G28\nG1 X1\n");
  {
    JobProgress start;
    start.sent_through = 2;
    JournalWriter writer(fileWriter({path, {}}, jobOf(program)), start, program.lines(), kLongestWrite);
    StreamStatus status = statusAt(2, 2);
    status.state = PackmlState::Complete;
    status.layer = 3;
    writer.record(status, 1.0);
  }
  const JobProgress known = readJournal(path).progress;
  EXPECT_EQ(known.state, PackmlState::Complete);
  EXPECT_EQ(known.taken_through, 2U);
  EXPECT_EQ(known.layer, 3);
  EXPECT_GT(known.time_ms, 1'600'000'000'000);
  EXPECT_THROW(resumeJournal(path, program, "/dev/printer"), InvalidInput) << "there is nothing left";
}

TEST(JobJournal, GoesOnWithTheSameProgramAtTheSamePortOnly) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto program = journalled("G28\nG1 X1\n");
  JobProgress start;
  start.sent_through = 2;
  { const ProgressFile file(path, jobOf(program), start); }
  EXPECT_EQ(resumeJournal(path, program, "/dev/printer").unfinished->job.line_base, 2'000'000U);
  EXPECT_THROW(resumeJournal(path, program, "/dev/other"), InvalidInput);
  EXPECT_THROW(resumeJournal(path, journalled("G28\nG1 X2\n"), "/dev/printer"), InvalidProgram);
  EXPECT_THROW(resumeJournal(folder.file("none"), program, "/dev/printer"), FileError);
  EXPECT_THROW(readJournal(""), FileError);
  for (const PackmlState stopped : {PackmlState::Aborting, PackmlState::Aborted}) {
    start.state = stopped;
    { const ProgressFile file(path, jobOf(program), start); }
    EXPECT_THROW(resumeJournal(path, program, "/dev/printer"), InvalidInput);
  }
}

/// The refusal of a program to go on with; empty if it is taken.
std::string refusalToGoOn(const std::string& path, const StreamableProgram& program) {
  try {
    resumeJournal(path, program, "/dev/printer");
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(JobJournal, GoesOnByTheSameCorrectionsOnly) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const ProgramOrigin origin{"base", {{1, "0123456789abcdef"}, {2, "1123456789abcdef"}}};
  const auto program = journalled("G28\nG1 X1\n");
  JobProgress start;
  start.sent_through = 2;
  { const ProgressFile file(path, describedJob(program.madeFrom(origin), "/dev/printer"), start); }
  EXPECT_EQ(refusalToGoOn(path, program.madeFrom(origin)), "");
  EXPECT_NE(refusalToGoOn(path, program).find("was corrected by 2 correction maps"), std::string::npos);
  ProgramOrigin other = origin;
  other.maps[1].digest = "2123456789abcdef";
  EXPECT_NE(refusalToGoOn(path, program.madeFrom(other))
                .find("given is layer 2 by map 2123456789abcdef; the job to go on with lays layer 2 by map "
                      "1123456789abcdef"),
            std::string::npos);
  other.maps.pop_back();
  EXPECT_NE(refusalToGoOn(path, program.madeFrom(other)).find("given is no further map"), std::string::npos);
  EXPECT_NE(refusalToGoOn(path, journalled("G28\nG1 X2\n").madeFrom(origin)).find("other settings (loop.*)"),
            std::string::npos);
  other = origin;
  other.program_sha256 = "another";
  EXPECT_NE(refusalToGoOn(path, journalled("G28\nG1 X2\n").madeFrom(other)).find("another program"),
            std::string::npos);
  { const ProgressFile file(path, jobOf(program), start); }
  EXPECT_NE(refusalToGoOn(path, program.madeFrom(origin)).find("the job to go on with has none"),
            std::string::npos);
}

/// Of a job that was corrected on its way, what its record makes is gone on with, as far as it goes.
TEST(JobJournal, GoesOnByTheRecordOfAJobCorrectedOnItsWayOnly) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto planned = journalled("G28\nG1 X1\n");
  const auto made = journalled("G28\nG1 X1\nG1 X2\nG1 X3\n");
  JournalledJob job = jobOf(planned);
  job.revision = RevisionRecord{"/prints/record", "first", "loop.lag_s=0"};
  JobProgress known;
  known.taken_through = 3;
  known.sent_through = 260;
  { const ProgressFile file(path, job, known); }
  const auto originOf = [&](const std::string& recorded, const std::string& settings) {
    return ProgramOrigin{
        job.program_sha256, {{1, "0123456789abcdef"}}, RevisionRecord{"/moved/record", recorded, settings}};
  };
  const ProgramOrigin origin = originOf("first", "loop.lag_s=0");
  const StreamJournal journal = resumeJournal(path, made.madeFrom(origin), "/dev/printer");
  ASSERT_TRUE(journal.unfinished);
  EXPECT_EQ(journal.unfinished->job.lines_total, 4U);
  EXPECT_EQ(journal.unfinished->job.line_base, job.line_base);
  EXPECT_EQ(journal.unfinished->job.program_sha256, sha256Of(made));
  EXPECT_FALSE(journal.unfinished->job.revision) << "from here on it is a program as any other";
  EXPECT_EQ(journal.unfinished->progress.taken_through, 3U);
  EXPECT_EQ(journal.unfinished->progress.sent_through, 4U);
  const auto refusal = [&](const ProgramOrigin& other) { return refusalToGoOn(path, made.madeFrom(other)); };
  EXPECT_NE(refusalToGoOn(path, planned).find("is recorded in /prints/record"), std::string::npos);
  EXPECT_NE(
      refusal(originOf("second", "loop.lag_s=0")).find("of job 'second'; the job to go on with is 'first'"),
      std::string::npos);
  EXPECT_NE(refusal(originOf("first", "loop.lag_s=1")).find("corrected is with loop.lag_s=1"),
            std::string::npos);
  ProgramOrigin other = origin;
  other.program_sha256 = "another";
  EXPECT_NE(refusal(other).find("has the SHA-256 another"), std::string::npos);
  EXPECT_NE(refusalToGoOn(path, planned.madeFrom(origin)).find("fewer than were taken"), std::string::npos);
}

TEST(JobJournal, FollowsAPrintWhateverIsKnownOfIt) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  const auto program = journalled("G28\nG1 X1\n");
  EXPECT_FALSE(followJournal(path, program, "/dev/printer").unfinished);
  JobProgress start;
  start.sent_through = 2;
  { const ProgressFile file(path, jobOf(program), start); }
  EXPECT_TRUE(followJournal(path, program, "/dev/printer").unfinished);
  EXPECT_FALSE(followJournal(path, program, "/dev/other").unfinished);
  EXPECT_FALSE(followJournal(path, journalled("G28\nG1 X2\n"), "/dev/printer").unfinished);
  EXPECT_FALSE(followJournal("", program, "/dev/printer").unfinished);
  writeFile(path, "no progress file");
  EXPECT_EQ(followJournal(path, program, "/dev/printer").path, path);
}

TEST(JobJournal, KnowsAnExecutionByItsName) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("port.progress");
  EXPECT_THROW(recordOf("", "3@17"), FileError) << "nothing is kept";
  EXPECT_EQ(recordOf(path, "3@17"), ExecutionRecord::None);
  JournalledJob job = jobOf(journalled("G28\nG1 X1\n"));
  job.execution = "3@17";
  JobProgress progress;
  progress.sent_through = 2;
  { const ProgressFile file(path, job, progress); }
  EXPECT_EQ(recordOf(path, "3@17"), ExecutionRecord::Unfinished);
  EXPECT_EQ(recordOf(path, "3@18"), ExecutionRecord::None) << "of another journal";
  keepUnfinished(path);
  job.execution = "";
  { const ProgressFile file(path, job, progress); }
  EXPECT_THROW(recordOf(path, "3@17"), InvalidInput) << "another job has run since";
  job.execution = "4@18";
  progress.state = PackmlState::Complete;
  { const ProgressFile file(path, job, progress); }
  EXPECT_EQ(recordOf(path, "4@18"), ExecutionRecord::Complete);
  writeFile(path, "no progress file");
  EXPECT_THROW(recordOf(path, "4@18"), FileError);
}

TEST(JobJournal, TellsWhatIsKnown) {
  JournalledProgress known;
  known.job.program = "/part.gcode";
  known.job.port = "/dev/printer";
  known.job.lines_total = 900;
  known.progress = {1, 300, 41, 2, PackmlState::Execute, 1'700'000'000'000};
  EXPECT_EQ(describeProgress(known),
            "/part.gcode at /dev/printer, Execute at 2023-11-14 22:13:20 UTC: line 41 of 900 was certainly "
            "taken, in layer 2; lines 42 to 300 are in doubt");
  known.job.origin = ProgramOrigin{"base", {{1, "0123456789abcdef"}}};
  EXPECT_EQ(describeProgress(known).substr(0, 60),
            "/part.gcode at /dev/printer, corrected by 1 correction map, ");
  known.job.origin.reset();
  known.job.uploaded_as = "lamina/part-1.gcode";
  EXPECT_EQ(
      describeProgress(known),
      "/part.gcode at /dev/printer, uploaded as lamina/part-1.gcode, Execute at 2023-11-14 22:13:20 UTC: the "
      "machine had read line 41 of 900, in layer 2; it prints on by itself, so that it may be further");
}

}  // namespace
}  // namespace lamina
