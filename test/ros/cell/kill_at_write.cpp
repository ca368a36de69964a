// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Preloaded into a process: kills it amid its nth write, or in front of its nth synchronisation, truncation
// or renaming, of files whose path contains a text.
//
//   LAMINA_KILL_AT    n, from 1
//   LAMINA_KILL_FILE  the text
#include <dlfcn.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

bool isWatched(const char* path) {
  const char* const text = std::getenv("LAMINA_KILL_FILE");
  return text != nullptr && std::strstr(path, text) != nullptr;
}

bool isWatched(int file) {
  std::array<char, 64> link{};
  std::array<char, 1024> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  return ::readlink(link.data(), path.data(), path.size() - 1) > 0 && isWatched(path.data());
}

/// True if this is the one.
bool isDue() {
  static std::atomic<long> count{0};
  const char* const at = std::getenv("LAMINA_KILL_AT");
  return at != nullptr && ++count == std::atol(at);
}

template <class File>
void dieIfDue(File file) {
  if (isWatched(file) && isDue()) ::kill(::getpid(), SIGKILL);
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

ssize_t written(const char* name, int file, const void* bytes, size_t count, off64_t place) {
  const auto write = real<ssize_t(int, const void*, size_t, off64_t)>(name);
  if (isWatched(file) && isDue()) {
    write(file, bytes, count / 2, place);
    ::kill(::getpid(), SIGKILL);
  }
  return write(file, bytes, count, place);
}

}  // namespace

extern "C" {

ssize_t pwrite(int file, const void* bytes, size_t count, off_t place) {
  return written("pwrite", file, bytes, count, place);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t place) {
  return written("pwrite64", file, bytes, count, place);
}

int fsync(int file) {
  dieIfDue(file);
  return real<int(int)>("fsync")(file);
}

int fdatasync(int file) {
  dieIfDue(file);
  return real<int(int)>("fdatasync")(file);
}

int ftruncate64(int file, off64_t length) noexcept {
  dieIfDue(file);
  return real<int(int, off64_t)>("ftruncate64")(file, length);
}

int rename(const char* from, const char* to) noexcept {
  dieIfDue(to);
  return real<int(const char*, const char*)>("rename")(from, to);
}
}
