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

/// The description of a job in its progress file; it does not change while the job runs.
struct JournalledJob {
  std::string program;              ///< path of the program's file, or id of the toolpath
  std::uint64_t program_bytes = 0;  ///< size of the program's text
  std::string program_sha256;       ///< digest of the program's text, 64 hexadecimal digits
  std::string port;                 ///< name of the machine's port
  std::string protocol;             ///< name in `firmwareProtocols`
  std::string firmware_name;
  std::uint64_t lines_total = 0;
  std::uint64_t line_base = 0;  ///< number of the line before the program's first; identifies the job
  std::string uploaded_as;      ///< file that a print server prints by itself; empty if lines are streamed
  std::optional<ProgramOrigin> origin;  ///< of a corrected program; nothing for any other
  /// The record of the corrections, if the program is corrected while it is sent; nothing otherwise. Digest
  /// and number of lines are then those of the program without corrections.
  std::optional<RevisionRecord> revision = std::nullopt;
  std::string execution = "";  ///< name that the client gave to this execution; empty for none
};

/// The progress of a job. Line numbers count the program's lines with a command, from 1; 0 for none. For a
/// print by a print server `taken_through` is the last line that it reported as read, and all lines count as
/// sent.
struct JobProgress {
  std::uint64_t sequence = 0;      ///< number of the record; the newest has the highest
  std::uint64_t sent_through = 0;  ///< no line after this one was ever sent
  /// Last line that the machine has certainly accepted. The last acknowledged lines do not count, as their
  /// oks may be answers to something else.
  std::uint64_t taken_through = 0;
  std::int32_t layer = -1;  ///< of the last line acknowledged; -1 before the first
  PackmlState state = PackmlState::Execute;
  std::int64_t time_ms = 0;  ///< time of the record, since 1970, UTC
};

/// A job and its last known progress.
struct JournalledProgress {
  JournalledJob job;
  JobProgress progress;
};

// Layout of a progress file: two progress records of `kProgressRecordBytes` each, which are overwritten
// alternately, then the job. All numbers are little-endian. Each record, and the job, ends with the CRC-32
// (ISO 3309) of the bytes before it. A record contains the CRC of its job, so that it cannot be mistaken for
// a record of another job.
inline constexpr std::size_t kProgressRecordBytes = 512;

/// The bytes of a progress record.
/// @param job_crc  CRC of the job, from `crcOf`
std::string encodeProgress(const JobProgress& progress, std::uint32_t job_crc);

/// The progress in the bytes of a record.
/// @return nothing if the bytes are no complete record of that job
std::optional<JobProgress> decodeProgress(std::string_view bytes, std::uint32_t job_crc);

/// The bytes of the job. Texts of more than 65535 bytes are cut.
std::string encodeJob(const JournalledJob& job);

/// The CRC with which the bytes of the job end.
std::uint32_t crcOf(std::string_view encoded_job);

/// Decodes a progress file: its job, and the newest complete record. If a write was interrupted, this is the
/// previous record.
/// @param name  name of the file, for messages
/// @throws FileError if it is no progress file, or damaged
JournalledProgress decodeJournal(std::string_view bytes, const std::string& name);

}  // namespace lamina
