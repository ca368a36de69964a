// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <random>
#include <system_error>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& path, int error_number) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code unknown;
  const bool is_folder_missing =
      error_number == ENOENT && !folder.empty() && !std::filesystem::exists(folder, unknown);
  if (error_number == EISDIR)
    throw FileError("cannot " + what + " '" + path + "': it is a folder; expected the name of a file");
  throw FileError(
      "cannot " + what + " '" + path + "': " +
      (is_folder_missing ? "there is no folder '" + folder.string() + "'" : std::strerror(error_number)));
}

/// A rename would put the file in the place of /dev/null, where the user may do so.
void requirePlaceForFile(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISLNK(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) fail("write", path, EISDIR);
  throw FileError("cannot write '" + path + "': it is " + kindOfFile(status.st_mode) +
                  "; expected the name of a file");
}

/// A name beside the path that others cannot guess.
std::string nameBeside(const std::string& path) {
  std::random_device device;
  const std::uint64_t number = (std::uint64_t{device()} << 32) | device();
  char digits[16];
  const auto result = std::to_chars(std::begin(digits), std::end(digits), number, 16);
  return path + "." + std::string(digits, result.ptr) + ".part";
}

/// What a link names, or a chain of links, as long as they are ours or root's.
std::string behindOwnLinks(std::string path) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  for (int links = 0; links < kMostLinks; ++links) {
    struct stat status {};
    const bool is_link = ::lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
    if (!is_link || (status.st_uid != ::geteuid() && status.st_uid != 0)) return path;
    std::error_code failure;
    const std::filesystem::path target = std::filesystem::read_symlink(path, failure);
    if (failure) return path;
    path = (std::filesystem::path(path).parent_path() / target).string();
  }
  return path;
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(behindOwnLinks(std::move(path))) {
  requirePlaceForFile(path_);
  // In a folder that others may write to, such as /tmp, somebody may have placed a link to a file of ours: a
  // new file is made, or none.
  temporary_path_ = nameBeside(path_);
  const int descriptor = ::open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor >= 0) file_ = ::fdopen(descriptor, "wb");
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

void writeFile(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void synchronise(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_kept = file >= 0 && ::fsync(file) == 0;
  const int error_number = errno;
  if (file >= 0) ::close(file);
  if (!is_kept) fail("force to the disk", path, error_number);
}

void writeDurably(const std::string& path, std::string_view bytes) {
  writeFile(path, bytes);
  synchronise(path);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  synchronise(folder.empty() ? "." : folder);
}

std::string readTextFile(const std::string& path) {
  std::string bytes = readFile(path);
  bytes.erase(0, bytes.size() - utf8Text(bytes, path).size());
  return bytes;
}

std::string readFile(const std::string& path) { return InputFile(path).readRest(); }

std::string readFile(const std::string& path, std::size_t most_bytes) {
  return InputFile(path).readRest({}, most_bytes);
}

}  // namespace lamina
