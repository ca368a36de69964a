// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/journal/job_progress.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

JournalledJob anyJob() {
  JournalledJob job;
  job.program = "/parts/part.gcode";
  job.program_bytes = 123456;
  job.program_sha256 = std::string(64, 'a');
  job.port = "/dev/ttyUSB0";
  job.protocol = "marlin";
  job.firmware_name = "Marlin 2.1.2";
  job.lines_total = 5000;
  job.line_base = 1'234'567;
  return job;
}

JobProgress progressAt(std::uint64_t sequence) {
  JobProgress progress;
  progress.sequence = sequence;
  progress.taken_through = 10 * sequence;
  progress.sent_through = 10 * sequence + 256;
  progress.layer = static_cast<std::int32_t>(sequence);
  progress.time_ms = 1'700'000'000'000;
  return progress;
}

/// A file whose last record is that of `sequence`, with the one before in the other slot.
std::string fileAt(std::uint64_t sequence, const JournalledJob& job) {
  const std::string encoded_job = encodeJob(job);
  const std::string newer = encodeProgress(progressAt(sequence), crcOf(encoded_job));
  const std::string older = encodeProgress(progressAt(sequence - 1), crcOf(encoded_job));
  return sequence % 2 == 0 ? newer + older + encoded_job : older + newer + encoded_job;
}

TEST(JobProgress, HasTheLayoutThatIsPromised) {
  JobProgress progress;
  progress.sequence = 0x0102030405060708;
  progress.layer = -1;
  const std::string bytes = encodeProgress(progress, 0xA1B2C3D4);
  ASSERT_EQ(bytes.size(), 512U);
  EXPECT_EQ(bytes.substr(0, 8), "LAMPROG1");
  EXPECT_EQ(bytes.substr(8, 4), "\xD4\xC3\xB2\xA1");
  EXPECT_EQ(bytes.substr(12, 8), "\x08\x07\x06\x05\x04\x03\x02\x01");
  EXPECT_EQ(bytes.substr(36, 4), "\xFF\xFF\xFF\xFF") << "layer -1";
}

TEST(JobProgress, IsReadBackAsItWasWritten) {
  const JournalledProgress read = decodeJournal(fileAt(7, anyJob()), "file");
  EXPECT_EQ(read.job.program, "/parts/part.gcode");
  EXPECT_EQ(read.job.program_bytes, 123456U);
  EXPECT_EQ(read.job.program_sha256, std::string(64, 'a'));
  EXPECT_EQ(read.job.port, "/dev/ttyUSB0");
  EXPECT_EQ(read.job.protocol, "marlin");
  EXPECT_EQ(read.job.firmware_name, "Marlin 2.1.2");
  EXPECT_EQ(read.job.lines_total, 5000U);
  EXPECT_EQ(read.job.line_base, 1'234'567U);
  EXPECT_EQ(read.progress.sequence, 7U);
  EXPECT_EQ(read.progress.taken_through, 70U);
  EXPECT_EQ(read.progress.sent_through, 326U);
  EXPECT_EQ(read.progress.layer, 7);
  EXPECT_EQ(read.progress.state, PackmlState::Execute);
  EXPECT_EQ(read.progress.time_ms, 1'700'000'000'000);
}

TEST(JobProgress, SaysWhatACorrectedProgramWasMadeFrom) {
  JournalledJob job = anyJob();
  EXPECT_FALSE(decodeJournal(fileAt(7, job), "file").job.origin);
  job.origin = ProgramOrigin{std::string(64, 'b'), {{1, "0123456789abcdef"}, {300, "fedcba9876543210"}}};
  const std::string file = fileAt(7, job);
  const JournalledJob read = decodeJournal(file, "file").job;
  ASSERT_TRUE(read.origin);
  EXPECT_EQ(read.origin->program_sha256, std::string(64, 'b'));
  EXPECT_EQ(read.origin->maps, job.origin->maps);
  EXPECT_EQ(read.uploaded_as, "");
  for (std::size_t i = 1024; i < file.size(); ++i) {
    std::string damaged = file;
    damaged[i] ^= '\x10';
    EXPECT_THROW(decodeJournal(damaged, "file"), FileError) << "byte " << i;
  }
}

/// What a program becomes on its way may have any number of lines.
TEST(JobProgress, SaysWhereItIsRecordedWhatAProgramWasCorrectedBy) {
  JournalledJob job = anyJob();
  job.lines_total = 100;
  EXPECT_THROW(decodeJournal(fileAt(7, job), "file"), FileError) << "326 lines were sent";
  job.revision = RevisionRecord{"/prints/record", "0123", "loop.lag_s=0.5"};
  const JournalledJob read = decodeJournal(fileAt(7, job), "file").job;
  ASSERT_TRUE(read.revision);
  EXPECT_EQ(read.revision->folder, "/prints/record");
  EXPECT_EQ(read.revision->job, "0123");
  EXPECT_EQ(read.revision->settings, "loop.lag_s=0.5");
  EXPECT_EQ(read.lines_total, 100U);
}

TEST(JobProgress, NamesTheExecutionIfItHasAName) {
  JournalledJob job = anyJob();
  EXPECT_EQ(encodeJob(job).substr(0, 8), "LAMJOB01") << "as older versions read it";
  job.execution = "12@1764000000.5";
  job.origin = ProgramOrigin{std::string(64, 'b'), {{1, "0123456789abcdef"}}};
  const JournalledJob read = decodeJournal(fileAt(7, job), "file").job;
  EXPECT_EQ(read.execution, "12@1764000000.5");
  EXPECT_EQ(read.program, "/parts/part.gcode");
  EXPECT_TRUE(read.origin);
}

TEST(JobProgress, NamesTheFileOfAPrintServersPrint) {
  JournalledJob job = anyJob();
  EXPECT_EQ(decodeJournal(fileAt(7, job), "file").job.uploaded_as, "");
  const std::size_t streamed = encodeJob(job).size();
  job.uploaded_as = "lamina/part-1.gcode";
  EXPECT_EQ(encodeJob(job).size(), streamed + 2 + 19) << "a length of two bytes, and the name";
  EXPECT_EQ(decodeJournal(fileAt(7, job), "file").job.uploaded_as, "lamina/part-1.gcode");
}

TEST(JobProgress, ATornWriteAtAnyByteLeavesTheRecordBefore) {
  const JournalledJob job = anyJob();
  const std::string before = fileAt(8, job);
  const std::string record = encodeProgress(progressAt(9), crcOf(encodeJob(job)));
  for (std::size_t torn = 0; torn <= record.size(); ++torn) {
    std::string file = before;
    file.replace(kProgressRecordBytes, torn, record.substr(0, torn));
    const std::uint64_t expected = file.substr(kProgressRecordBytes, kProgressRecordBytes) == record ? 9 : 8;
    EXPECT_EQ(decodeJournal(file, "file").progress.sequence, expected) << "torn after " << torn << " bytes";
  }
}

TEST(JobProgress, NoByteCanBeOtherThanItWasWritten) {
  const std::string record = encodeProgress(progressAt(3), 99);
  ASSERT_TRUE(decodeProgress(record, 99));
  EXPECT_FALSE(decodeProgress(record, 98)) << "the record of another job";
  for (std::size_t at = 0; at < record.size(); ++at) {
    std::string damaged = record;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_FALSE(decodeProgress(damaged, 99)) << "byte " << at;
  }
}

TEST(JobProgress, IsRefusedWhereTheFileIsCut) {
  const std::string file = fileAt(4, anyJob());
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_THROW(decodeJournal(file.substr(0, size), "file"), FileError) << size << " bytes";
}

RC_GTEST_PROP(JobProgress, AnyBytesAreReadOrRefused, (const std::string& noise)) {
  std::string file = fileAt(4, anyJob());
  const auto at = *rc::gen::inRange<std::size_t>(0, file.size());
  file.replace(at, noise.size(), noise);
  try {
    const JournalledProgress read = decodeJournal(file, "file");
    RC_ASSERT(read.progress.sequence == 4U || read.progress.sequence == 3U);
    RC_ASSERT(read.job.line_base == 1'234'567U);
  } catch (const FileError&) {
  }
  try {
    decodeJournal(noise, "noise");
    RC_FAIL("noise is no progress file");
  } catch (const FileError&) {
  }
}

RC_GTEST_PROP(JobProgress, EveryProgressIsReadBack,
              (std::uint64_t sent, std::uint64_t taken, std::int32_t layer, std::int64_t time_ms)) {
  JobProgress progress{1, sent, taken, layer, PackmlState::Held, time_ms};
  const auto read = decodeProgress(encodeProgress(progress, 5), 5);
  RC_ASSERT(read.has_value());
  RC_ASSERT(read->sent_through == sent);
  RC_ASSERT(read->taken_through == taken);
  RC_ASSERT(read->layer == layer);
  RC_ASSERT(read->time_ms == time_ms);
  RC_ASSERT(read->state == PackmlState::Held);
}

}  // namespace
}  // namespace lamina
