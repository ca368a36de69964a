// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/artefact_store.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

void copyInto(const std::string& path, const std::string& target) {
  std::ifstream from(path, std::ios::binary);
  if (!from) throw FileError(path + ": cannot be read");
  AtomicFile to(target);
  std::array<char, 65536> piece{};
  while (from) {
    from.read(piece.data(), piece.size());
    to.write({piece.data(), static_cast<std::size_t>(from.gcount())});
  }
  if (from.bad()) throw FileError(path + ": cannot be read to its end");
  to.commit();
}

/// @throws FileError if the folder does not say so
bool isKept(const std::string& target) {
  std::error_code error;
  const bool is_there = std::filesystem::exists(target, error);
  if (error) throw FileError("cannot look for '" + target + "': " + error.message());
  return is_there;
}

std::uint64_t sizeOf(const std::string& target) {
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(target, error);
  if (error) throw FileError("cannot tell the size of '" + target + "': " + error.message());
  return bytes;
}

/// Brings a file that was written into the store to the disk, read-only: no row of the journal outlives what
/// it names.
void seal(const std::string& target) {
  synchronise(target);
  synchronise(std::filesystem::path(target).parent_path());
  std::error_code ignored;
  std::filesystem::permissions(
      target, std::filesystem::perms::owner_read | std::filesystem::perms::group_read, ignored);
}

/// The suffix of a name if it is a plain one, so that readers know what kind of file it is.
std::string suffixOf(const std::string& name) {
  const std::string suffix = std::filesystem::path(name).extension();
  const bool is_plain =
      suffix.size() > 1 && suffix.size() <= 8 &&
      std::all_of(suffix.begin() + 1, suffix.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
  return is_plain ? suffix : "";
}

/// What of a file changes whenever its bytes are written.
struct FileVersion {
  dev_t device = 0;
  ino_t file = 0;
  off_t size = 0;
  timespec written{};
  timespec changed{};
};

bool operator==(const FileVersion& a, const FileVersion& b) {
  const auto is_same = [](const timespec& x, const timespec& y) {
    return x.tv_sec == y.tv_sec && x.tv_nsec == y.tv_nsec;
  };
  return a.device == b.device && a.file == b.file && a.size == b.size && is_same(a.written, b.written) &&
         is_same(a.changed, b.changed);
}

std::optional<FileVersion> fileVersionOf(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return std::nullopt;
  return FileVersion{found.st_dev, found.st_ino, found.st_size, found.st_mtim, found.st_ctim};
}

}  // namespace

/// Digests of files that were read, for as long as nobody has written them. Several threads may ask.
class ArtefactStore::ReadFiles {
 public:
  std::string digestOf(const std::string& path) {
    const auto before = fileVersionOf(path);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto known = known_.find(path);
      if (before && known != known_.end() && known->second.first == *before) return known->second.second;
    }
    std::string digest = sha256OfFile(path);
    const std::lock_guard<std::mutex> lock(mutex_);
    // What was written while it was read is read again the next time.
    if (before && fileVersionOf(path) == before) known_[path] = {*before, digest};
    return digest;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::pair<FileVersion, std::string>> known_;
};

ArtefactStore::ArtefactStore() : read_(std::make_unique<ReadFiles>()) {}

ArtefactStore::ArtefactStore(ArtefactStore&&) noexcept = default;

ArtefactStore::~ArtefactStore() = default;

ArtefactStore::ArtefactStore(std::string folder)
    : folder_(std::move(folder)), read_(std::make_unique<ReadFiles>()) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  std::error_code unknown;
  if (!std::filesystem::is_directory(folder_, unknown))
    throw FileError(folder_ + ": cannot be made: " + (error ? error.message() : "it is no folder"));
  std::filesystem::permissions(folder_, std::filesystem::perms::owner_all, error);
}

Artefact ArtefactStore::keep(const std::string& path, const std::string& kind, const std::string& name) {
  return keepFile(path, kind, name).artefact;
}

KeptFile ArtefactStore::keepFile(const std::string& path, const std::string& kind, const std::string& name) {
  KeptFile kept{{sha256OfFile(path), 0, kind, name}, false};
  Artefact& artefact = kept.artefact;
  const std::string target = pathOf(artefact);
  kept.is_new = !isKept(target);
  try {
    if (kept.is_new || read_->digestOf(target) != artefact.sha256) {
      copyInto(path, target);
      seal(target);
    }
    // The file may have changed between the two times that it was read.
    if (read_->digestOf(target) != artefact.sha256) throw FileError(path + ": changed while it was kept");
    artefact.bytes = sizeOf(target);
  } catch (...) {
    if (kept.is_new) remove(artefact);
    throw;
  }
  return kept;
}

void ArtefactStore::remove(const Artefact& artefact) {
  std::error_code ignored;
  std::filesystem::remove(pathOf(artefact), ignored);
}

Artefact ArtefactStore::keepText(const std::string& bytes, const std::string& kind, const std::string& name) {
  Artefact artefact{sha256Of(std::string_view(bytes)), bytes.size(), kind, name};
  const std::string target = pathOf(artefact);
  if (isKept(target) && read_->digestOf(target) == artefact.sha256) return artefact;
  AtomicFile to(target);
  to.write(bytes);
  to.commit();
  seal(target);
  return artefact;
}

ArtefactStore ArtefactStore::toRead(std::string folder) {
  ArtefactStore store;
  store.folder_ = std::move(folder);
  return store;
}

std::string ArtefactStore::pathOf(const Artefact& artefact) const {
  return folder_ + '/' + artefact.sha256 + suffixOf(artefact.name);
}

std::vector<std::string> ArtefactStore::torn(const std::vector<Artefact>& artefacts) const {
  std::vector<std::string> torn;
  for (const Artefact& artefact : artefacts) {
    try {
      if (read_->digestOf(pathOf(artefact)) != artefact.sha256) torn.push_back(artefact.name);
    } catch (const FileError&) {
      torn.push_back(artefact.name);
    }
  }
  return torn;
}

}  // namespace lamina
