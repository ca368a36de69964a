// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path, int error_number) {
  throw FileError("cannot " + what + " '" + path + "': " + std::strerror(error_number));
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  temporary_path_ = path_ + "." + std::to_string(::getpid()) + ".part";
  file_ = std::fopen(temporary_path_.c_str(), "wb");
  if (file_ == nullptr) fail("write", path_, errno);
}

AtomicFile::~AtomicFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(temporary_path_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail("write", path_, errno);
}

void AtomicFile::commit() {
  // Flushed before the rename, so that a full disk is found while the old file still stands.
  if (std::fflush(file_) != 0) fail("write", path_, errno);
  std::FILE* file = file_;
  file_ = nullptr;
  const bool is_closed = std::fclose(file) == 0;
  if (is_closed && std::rename(temporary_path_.c_str(), path_.c_str()) == 0) return;
  const int error_number = errno;
  std::remove(temporary_path_.c_str());
  fail("write", path_, error_number);
}

std::string readFile(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail("read", path, errno);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || S_ISDIR(status.st_mode)) {
    ::close(descriptor);
    fail("read", path, EISDIR);
  }
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t length = 0;
  constexpr std::size_t kChunk = 1 << 16;
  for (;;) {
    if (length == bytes.size()) bytes.resize(bytes.size() + kChunk);
    const ssize_t got = ::read(descriptor, bytes.data() + length, bytes.size() - length);
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      const int error_number = errno;
      ::close(descriptor);
      fail("read", path, error_number);
    }
    length += static_cast<std::size_t>(got);
  }
  ::close(descriptor);
  bytes.resize(length);
  return bytes;
}

}  // namespace lamina
