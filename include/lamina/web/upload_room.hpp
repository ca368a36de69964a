// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace lamina {

/// How many bytes the disk of a folder has left.
using FreeBytes = std::function<std::uint64_t(const std::string& folder)>;

/// What the system says; 0 if it does not, so that nothing is promised.
std::uint64_t freeForUploads(const std::string& folder);

struct UploadPromises;

/// Room on a disk that was promised to an upload, and is given back with this.
class UploadPlace {
 public:
  UploadPlace(std::shared_ptr<UploadPromises> promises, std::uint64_t bytes);
  ~UploadPlace();
  UploadPlace(const UploadPlace&) = delete;
  UploadPlace& operator=(const UploadPlace&) = delete;

  /// Notes bytes that were written. Each 16 MiB, looks whether the disk still has what was promised.
  /// @throws UploadTooLarge (507) if it would have less than 1 GiB left
  void note(std::uint64_t written);

 private:
  std::shared_ptr<UploadPromises> promises_;
  std::uint64_t left_;
  std::uint64_t unchecked_ = 0;
};

/// Room on a disk for uploads that run at a time: all together leave 1 GiB, which the journal needs. Several
/// threads call at a time.
class UploadRoom {
 public:
  explicit UploadRoom(std::string folder, FreeBytes free_bytes = freeForUploads);

  /// Promises room for an upload of so many bytes and for its copy in the store of the cell.
  /// @return nothing if the disk has not enough beside what others were promised
  std::shared_ptr<UploadPlace> reserve(std::uint64_t bytes);

 private:
  std::shared_ptr<UploadPromises> promises_;
};

}  // namespace lamina
