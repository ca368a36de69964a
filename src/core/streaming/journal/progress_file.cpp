// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/journal/progress_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

[[noreturn]] void throwNotKept(const std::string& path, int error_number) {
  throw FileError("cannot keep the progress file " + path + ": " + std::strerror(error_number));
}

bool writeAt(int descriptor, std::string_view bytes, off_t place) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor, bytes.data(), bytes.size(), place);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += written;
  }
  return true;
}

/// A rename is on the disk when its folder is.
bool syncFolderOf(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_synced = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return is_synced;
}

}  // namespace

ProgressFile::ProgressFile(const std::string& path, const JournalledJob& job, const JobProgress& progress)
    : path_(path) {
  const std::string encoded_job = encodeJob(job);
  job_crc_ = crcOf(encoded_job);
  JobProgress first = progress;
  first.sequence = sequence_ = 1;
  const std::string record = encodeProgress(first, job_crc_);
  std::string temporary = path + ".XXXXXX";
  descriptor_ = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor_ < 0) throwNotKept(path, errno);
  const std::string empty(kProgressRecordBytes, '\0');
  if (writeAt(descriptor_, empty + record + encoded_job, 0) && ::fsync(descriptor_) == 0 &&
      ::rename(temporary.c_str(), path.c_str()) == 0 && syncFolderOf(path))
    return;
  const int error_number = errno;
  ::unlink(temporary.c_str());
  ::close(descriptor_);
  throwNotKept(path, error_number);
}

ProgressFile::~ProgressFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

ProgressFile::ProgressFile(ProgressFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      job_crc_(other.job_crc_),
      sequence_(other.sequence_) {}

void ProgressFile::write(JobProgress progress) {
  progress.sequence = ++sequence_;
  const off_t place = progress.sequence % 2 == 0 ? 0 : static_cast<off_t>(kProgressRecordBytes);
  if (!writeAt(descriptor_, encodeProgress(progress, job_crc_), place) || ::fdatasync(descriptor_) != 0)
    throwNotKept(path_, errno);
}

std::function<void(const JobProgress& progress)> fileWriter(const StreamJournal& where,
                                                            const JournalledJob& job) {
  return [path = where.path, resumes = where.unfinished.has_value(), job,
          file = std::shared_ptr<ProgressFile>()](const JobProgress& progress) mutable {
    if (file) return file->write(stampedNow(progress));
    if (!resumes) keepUnfinished(path);
    file = std::make_shared<ProgressFile>(path, job, stampedNow(progress));
  };
}

}  // namespace lamina
