// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/job/packml.hpp"
#include "lamina/streaming/job/program_origin.hpp"

namespace lamina {

/// What stays the same of a job that a progress file is kept of.
struct JournalledJob {
  std::string program;  ///< path of the file, or id of the toolpath
  std::uint64_t program_bytes = 0;
  std::string program_sha256;  ///< of the lines that are sent, 64 hexadecimal digits
  std::string port;
  std::string protocol;  ///< in `firmwareProtocols`
  std::string firmware_name;
  std::uint64_t lines_total = 0;
  std::uint64_t line_base =
      0;  ///< number of the line before the program's first, by which the job is known again
  std::string uploaded_as;  ///< file that a print server prints by itself; empty where lines are streamed
  std::optional<ProgramOrigin> origin;  ///< of a corrected program
  /// Of a program that is corrected on its way: what it becomes is in the record, and its digest and lines
  /// are those of the program without corrections.
  std::optional<RevisionRecord> revision = std::nullopt;
};

/// How far a job is. Lines are those of the program that carry a command, from 1. Of a print server's print
/// `taken_through` is the last line that it has read, by its own last word, and all lines have left.
struct JobProgress {
  std::uint64_t sequence = 0;       ///< of the record; the highest is the newest
  std::uint64_t sent_through = 0;   ///< no line beyond has ever left
  std::uint64_t taken_through = 0;  ///< certainly taken by the machine: acknowledged, but for the last ones,
                                    ///< whose oks may be those of something else
  std::int32_t layer = -1;          ///< of the last line acknowledged; -1 before the first
  PackmlState state = PackmlState::Execute;
  std::int64_t time_ms = 0;  ///< since 1970, UTC
};

/// A job and the last that is known of it.
struct JournalledProgress {
  JournalledJob job;
  JobProgress progress;
};

// A progress file: two records of `kProgressRecordBytes`, written in turn, then the job. All numbers are
// little-endian; records and job end with the CRC-32 (ISO 3309) of what is before it. A record carries the
// job's CRC, so that it is never taken for another job's.
inline constexpr std::size_t kProgressRecordBytes = 512;

/// @param job_crc  as `crcOf` gives it
std::string encodeProgress(const JobProgress& progress, std::uint32_t job_crc);

/// @return nothing if the bytes are no whole record of that job
std::optional<JobProgress> decodeProgress(std::string_view bytes, std::uint32_t job_crc);

/// The job's part of the file. Texts of more than 65535 bytes are cut.
std::string encodeJob(const JournalledJob& job);

/// The CRC that the encoded job ends with.
std::uint32_t crcOf(std::string_view encoded_job);

/// Reads a progress file: the newest whole record counts, so that a write that was torn leaves the one
/// before.
/// @param name  of the file, for errors
/// @throws FileError if it is none, or damaged
JournalledProgress decodeJournal(std::string_view bytes, const std::string& name);

}  // namespace lamina
