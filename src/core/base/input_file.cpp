// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/input_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/threads/held_signals.hpp"
#include "lamina/base/available_memory.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

[[noreturn]] void fail(const std::string& path, int error_number) {
  throw FileError("cannot read '" + path + "': " + std::strerror(error_number));
}

[[noreturn]] void cancel(const std::string& path) {
  throw Cancelled("cancelled while '" + path + "' was read");
}

bool isDescriptor(const std::string& path) {
  const auto begins = [&path](std::string_view with) { return path.compare(0, with.size(), with) == 0; };
  return path == "/dev/stdin" || begins("/dev/fd/") || begins("/proc/self/fd/");
}

std::string megabytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f MB", bytes / 1e6);
  return text;
}

}  // namespace

const char* kindOfFile(unsigned mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

InputFile::InputFile(std::string path) : path_(std::move(path)) {
  // Without waiting for whoever might write to a pipe.
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail(path_, errno);
  struct stat status {};
  const bool is_known = ::fstat(descriptor_, &status) == 0;
  const int error_number = errno;
  const bool is_taken =
      is_known && (S_ISREG(status.st_mode) || (isDescriptor(path_) && !S_ISDIR(status.st_mode)));
  if (!is_taken) ::close(descriptor_);
  if (!is_known) fail(path_, error_number);
  if (!is_taken)
    throw FileError("cannot read '" + path_ + "': it is " + kindOfFile(status.st_mode) +
                    "; expected a regular file, or /dev/stdin");
  size_ = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(char* buffer, std::size_t count) {
  if (!held_) held_ = std::make_unique<const HeldSignals>();
  std::size_t length = 0;
  while (length < count) {
    if (held_->haveCome()) cancel(path_);
    const ssize_t got = ::read(descriptor_, buffer + length, count - length);
    if (got == 0) {
      held_.reset();
      break;
    }
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) {
      wait();
      continue;
    }
    if (got < 0) fail(path_, errno);
    length += static_cast<std::size_t>(got);
  }
  return length;
}

void InputFile::wait() const {
  pollfd waited{descriptor_, POLLIN, 0};
  if (::ppoll(&waited, 1, nullptr, &held_->before()) >= 0) return;
  if (errno == EINTR) cancel(path_);
  fail(path_, errno);
}

std::size_t mostBytesInMemory(double available_bytes, std::size_t size) {
  constexpr double kMostOfMemory = 0.8;
  constexpr double kMost = 1e15;  // where the machine does not say what memory it has
  constexpr double kGrowing = 3.0;
  const double room = std::min(kMostOfMemory * available_bytes, kMost);
  return static_cast<std::size_t>(size > 0 ? room : room / kGrowing);
}

std::string InputFile::readRest(std::string_view read_before) {
  return readRest(read_before, mostBytesInMemory(availableMemory(), size_));
}

std::string InputFile::readRest(std::string_view read_before, std::size_t most_bytes) {
  constexpr std::size_t kChunk = 1 << 16;
  const auto requireRoomFor = [&](std::size_t bytes) {
    if (bytes > most_bytes)
      throw FileError("cannot read '" + path_ + "': it has " + megabytes(static_cast<double>(bytes)) +
                      " or more; expected at most " + megabytes(static_cast<double>(most_bytes)));
  };
  requireRoomFor(size_);
  std::string bytes(read_before);
  bytes.reserve(size_ + kChunk);
  // In one go as far as the size is known; what has no size, or has grown since, follows in chunks.
  std::size_t wanted = size_ > bytes.size() ? size_ - bytes.size() : kChunk;
  for (bool is_at_end = false; !is_at_end; wanted = kChunk) {
    const std::size_t length = bytes.size();
    bytes.resize(length + wanted);
    const std::size_t got = read(bytes.data() + length, wanted);
    bytes.resize(length + got);
    requireRoomFor(bytes.size());
    is_at_end = got < wanted;
  }
  return bytes;
}

std::string pathInAnyCase(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path file(path);
  if (fs::exists(file, unknown)) return path;
  const fs::path folder = file.parent_path();
  const std::string wanted = lowerCase(file.filename().string());
  std::string found;
  std::error_code listing;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, listing);
       !listing && entry != fs::directory_iterator(); entry.increment(listing)) {
    const std::string name = entry->path().filename().string();
    if (lowerCase(name) == wanted && (found.empty() || name < found)) found = name;
  }
  // Where the folder is not there either, whoever opens the file says so.
  if (listing && fs::exists(folder, unknown))
    throw FileError("cannot read '" + path + "': its folder cannot be listed: " + listing.message());
  return found.empty() ? path : (folder / found).string();
}

void requireReadable(const std::string& path) { const InputFile file(path); }

}  // namespace lamina
