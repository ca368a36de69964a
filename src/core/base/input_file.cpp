// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

[[noreturn]] void fail(const std::string& path, int error_number) {
  throw FileError("cannot read '" + path + "': " + std::strerror(error_number));
}

}  // namespace

InputFile::InputFile(std::string path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(path_, errno);
  struct stat status {};
  const bool is_known = ::fstat(descriptor_, &status) == 0;
  if (!is_known || S_ISDIR(status.st_mode)) {
    const int error_number = is_known ? EISDIR : errno;
    ::close(descriptor_);
    fail(path_, error_number);
  }
  size_ = static_cast<std::size_t>(status.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(char* buffer, std::size_t count) {
  std::size_t length = 0;
  while (length < count) {
    const ssize_t got = ::read(descriptor_, buffer + length, count - length);
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, errno);
    length += static_cast<std::size_t>(got);
  }
  return length;
}

std::string InputFile::readRest(std::string_view read_before) {
  constexpr std::size_t kChunk = 1 << 16;
  std::string bytes(read_before);
  bytes.reserve(size_ + kChunk);
  // In one go as far as the size is known; what has no size, or has grown since, follows in chunks.
  std::size_t wanted = size_ > bytes.size() ? size_ - bytes.size() : kChunk;
  for (bool is_at_end = false; !is_at_end; wanted = kChunk) {
    const std::size_t length = bytes.size();
    bytes.resize(length + wanted);
    const std::size_t got = read(bytes.data() + length, wanted);
    bytes.resize(length + got);
    is_at_end = got < wanted;
  }
  return bytes;
}

}  // namespace lamina
