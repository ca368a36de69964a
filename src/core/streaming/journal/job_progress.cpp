// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/journal/job_progress.hpp"

#include <algorithm>
#include <boost/crc.hpp>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kRecordMark = "LAMPROG1";
constexpr std::string_view kJobMark = "LAMJOB01";
constexpr std::string_view kNamedJobMark = "LAMJOB02";  // begins with the name of the execution
constexpr std::size_t kCrcBytes = 4;
constexpr std::size_t kLongestText = 65535;
constexpr std::size_t kDigestBytes = 16;

std::uint32_t crc32Of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

void append(std::string& bytes, std::uint64_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
}

void appendText(std::string& bytes, std::string_view text) {
  text = text.substr(0, kLongestText);
  append(bytes, text.size(), 2);
  bytes += text;
}

/// Takes values from the front of bytes; what is missing reads as 0 and is remembered.
class FrontReader {
 public:
  explicit FrontReader(std::string_view bytes) : left_(bytes) {}

  std::uint64_t integer(std::size_t count) {
    std::uint64_t value = 0;
    const std::string_view taken = take(count);
    for (std::size_t i = 0; i < taken.size(); ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(taken[i])) << (8 * i);
    return value;
  }
  std::string text() { return std::string(take(integer(2))); }
  std::string_view take(std::size_t count) {
    if (count > left_.size()) is_short_ = true;
    const std::string_view taken = is_short_ ? std::string_view() : left_.substr(0, count);
    left_.remove_prefix(taken.size());
    return taken;
  }
  bool isShort() const { return is_short_; }
  bool isAtEnd() const { return left_.empty(); }

 private:
  std::string_view left_;
  bool is_short_ = false;
};

bool endsWithItsCrc(std::string_view bytes) {
  return bytes.size() >= kCrcBytes && crcOf(bytes) == crc32Of(bytes.substr(0, bytes.size() - kCrcBytes));
}

void appendOrigin(std::string& bytes, const ProgramOrigin& origin) {
  appendText(bytes, origin.program_sha256);
  append(bytes, origin.maps.size(), 8);
  for (const AppliedMap& map : origin.maps) {
    append(bytes, map.layer, 8);
    std::string digest = map.digest;
    digest.resize(kDigestBytes, ' ');
    bytes += digest;
  }
}

ProgramOrigin readOrigin(FrontReader& reader) {
  ProgramOrigin origin;
  origin.program_sha256 = reader.text();
  const std::uint64_t count = reader.integer(8);
  for (std::uint64_t i = 0; i < count && !reader.isShort(); ++i) {
    AppliedMap map;
    map.layer = reader.integer(8);
    map.digest = std::string(reader.take(kDigestBytes));
    origin.maps.push_back(std::move(map));
  }
  return origin;
}

std::optional<JournalledJob> decodeJob(std::string_view bytes) {
  if (!endsWithItsCrc(bytes)) return std::nullopt;
  FrontReader reader(bytes.substr(0, bytes.size() - kCrcBytes));
  const std::string_view mark = reader.take(kJobMark.size());
  if (mark != kJobMark && mark != kNamedJobMark) return std::nullopt;
  JournalledJob job;
  if (mark == kNamedJobMark) job.execution = reader.text();
  job.program = reader.text();
  job.program_bytes = reader.integer(8);
  job.program_sha256 = reader.text();
  job.port = reader.text();
  job.protocol = reader.text();
  job.firmware_name = reader.text();
  job.lines_total = reader.integer(8);
  job.line_base = reader.integer(8);
  if (!reader.isAtEnd()) job.uploaded_as = reader.text();
  if (!reader.isAtEnd()) job.origin = readOrigin(reader);
  if (!reader.isAtEnd()) {
    job.revision.emplace();
    job.revision->folder = reader.text();
    job.revision->job = reader.text();
    job.revision->settings = reader.text();
  }
  if (reader.isShort() || !reader.isAtEnd()) return std::nullopt;
  return job;
}

[[noreturn]] void throwNoJournal(const std::string& name, const std::string& why) {
  throw FileError(name + " is no progress file that can be used: " + why);
}

}  // namespace

std::string encodeProgress(const JobProgress& progress, std::uint32_t job_crc) {
  std::string bytes(kRecordMark);
  append(bytes, job_crc, 4);
  append(bytes, progress.sequence, 8);
  append(bytes, progress.sent_through, 8);
  append(bytes, progress.taken_through, 8);
  append(bytes, static_cast<std::uint32_t>(progress.layer), 4);
  append(bytes, static_cast<std::uint64_t>(progress.state), 1);
  append(bytes, static_cast<std::uint64_t>(progress.time_ms), 8);
  bytes.resize(kProgressRecordBytes - kCrcBytes, '\0');
  append(bytes, crc32Of(bytes), kCrcBytes);
  return bytes;
}

std::optional<JobProgress> decodeProgress(std::string_view bytes, std::uint32_t job_crc) {
  if (bytes.size() != kProgressRecordBytes || !endsWithItsCrc(bytes)) return std::nullopt;
  FrontReader reader(bytes);
  if (reader.take(kRecordMark.size()) != kRecordMark || reader.integer(4) != job_crc) return std::nullopt;
  JobProgress progress;
  progress.sequence = reader.integer(8);
  progress.sent_through = reader.integer(8);
  progress.taken_through = reader.integer(8);
  progress.layer = static_cast<std::int32_t>(static_cast<std::uint32_t>(reader.integer(4)));
  const std::uint64_t state = reader.integer(1);
  if (state > static_cast<std::uint64_t>(PackmlState::Resetting)) return std::nullopt;
  progress.state = static_cast<PackmlState>(state);
  progress.time_ms = static_cast<std::int64_t>(reader.integer(8));
  return progress;
}

std::string encodeJob(const JournalledJob& job) {
  std::string bytes(job.execution.empty() ? kJobMark : kNamedJobMark);
  if (!job.execution.empty()) appendText(bytes, job.execution);
  appendText(bytes, job.program);
  append(bytes, job.program_bytes, 8);
  appendText(bytes, job.program_sha256);
  appendText(bytes, job.port);
  appendText(bytes, job.protocol);
  appendText(bytes, job.firmware_name);
  append(bytes, job.lines_total, 8);
  append(bytes, job.line_base, 8);
  const bool has_origin = job.origin || job.revision;
  if (!job.uploaded_as.empty() || has_origin) appendText(bytes, job.uploaded_as);
  if (has_origin) appendOrigin(bytes, job.origin.value_or(ProgramOrigin{job.program_sha256, {}}));
  if (job.revision) {
    appendText(bytes, job.revision->folder);
    appendText(bytes, job.revision->job);
    appendText(bytes, job.revision->settings);
  }
  append(bytes, crc32Of(bytes), kCrcBytes);
  return bytes;
}

std::uint32_t crcOf(std::string_view encoded_job) {
  return static_cast<std::uint32_t>(
      FrontReader(encoded_job.substr(encoded_job.size() - kCrcBytes)).integer(kCrcBytes));
}

JournalledProgress decodeJournal(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kRecords = 2 * kProgressRecordBytes;
  if (bytes.size() <= kRecords) {
    throwNoJournal(name, "it has " + std::to_string(bytes.size()) + " bytes; expected more than " +
                             std::to_string(kRecords));
  }
  const std::string_view encoded_job = bytes.substr(kRecords);
  const auto job = decodeJob(encoded_job);
  if (!job) throwNoJournal(name, "what it says of the job is damaged");
  std::optional<JobProgress> newest;
  for (const std::size_t slot : {std::size_t{0}, kProgressRecordBytes}) {
    const auto progress = decodeProgress(bytes.substr(slot, kProgressRecordBytes), crcOf(encoded_job));
    if (progress && (!newest || progress->sequence > newest->sequence)) newest = progress;
  }
  if (!newest) throwNoJournal(name, "both its records are damaged");
  const bool is_beyond = !job->revision && newest->sent_through > job->lines_total;
  if (newest->taken_through > newest->sent_through || is_beyond)
    throwNoJournal(name, "its line numbers contradict each other");
  return {*job, *newest};
}

}  // namespace lamina
