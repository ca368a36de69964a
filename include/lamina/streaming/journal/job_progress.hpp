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

/// The description of a job in its progress file, which does not change while the job runs.
struct JournalledJob {
  std::string program;  ///< path of the file, or id of the toolpath
  std::uint64_t program_bytes = 0;
  std::string program_sha256;  ///< of the lines that are sent, 64 hexadecimal digits
  std::string port;
  std::string protocol;  ///< in `firmwareProtocols`
  std::string firmware_name;
  std::uint64_t lines_total = 0;
  std::uint64_t line_base = 0;  ///< number of the line before the program's first; identifies the job
  std::string uploaded_as;      ///< file that a print server prints by itself; empty if lines are streamed
  std::optional<ProgramOrigin> origin;  ///< of a corrected program
  /// The record of a program that is corrected while it is sent. Digest and lines are then those of the
  /// program without corrections.
  std::optional<RevisionRecord> revision = std::nullopt;
  std::string execution = "";  ///< name that whoever ordered the job has given it; empty for none
};

/// The progress of a job. Lines are those of the program that carry a command, from 1. For a print by a print
/// server `taken_through` is the last line that it reported as read, and all lines count as sent.
struct JobProgress {
  std::uint64_t sequence = 0;       ///< number of the record; the newest has the highest
  std::uint64_t sent_through = 0;   ///< no line after it was ever sent
  std::uint64_t taken_through = 0;  ///< certainly taken by the machine: acknowledged, except the last ones,
                                    ///< whose oks may answer something else
  std::int32_t layer = -1;          ///< of the last line acknowledged; -1 before the first
  PackmlState state = PackmlState::Execute;
  std::int64_t time_ms = 0;  ///< since 1970, UTC
};

/// A job and its last known progress.
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

/// Decodes a progress file by its newest whole record, so that an interrupted write leaves the one before.
/// @param name  of the file, for errors
/// @throws FileError if it is no progress file, or damaged
JournalledProgress decodeJournal(std::string_view bytes, const std::string& name);

}  // namespace lamina
