// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace lamina {

/// Returns the free space on the disk of a folder [bytes].
using FreeBytes = std::function<std::uint64_t(const std::string& folder)>;

/// The free space according to the system; 0 if it does not report any, so that nothing is reserved.
std::uint64_t freeForUploads(const std::string& folder);

struct UploadPromises;

/// Room on a disk that is reserved for an upload, until this object is destroyed.
class UploadPlace {
 public:
  UploadPlace(std::shared_ptr<UploadPromises> promises, std::uint64_t bytes);
  ~UploadPlace();
  UploadPlace(const UploadPlace&) = delete;
  UploadPlace& operator=(const UploadPlace&) = delete;

  /// Takes written bytes off the reserved room. After every 16 MiB, checks that the disk still has what is
  /// reserved.
  /// @throws UploadTooLarge (507) if less than 1 GiB would be left
  void note(std::uint64_t written);

 private:
  std::shared_ptr<UploadPromises> promises_;
  std::uint64_t left_;
  std::uint64_t unchecked_ = 0;
};

/// Reserves room on a disk for concurrent uploads, such that 1 GiB is left, which the journal needs. May be
/// called from several threads.
class UploadRoom {
 public:
  explicit UploadRoom(std::string folder, FreeBytes free_bytes = freeForUploads);

  /// Reserves room for an upload of that size, and for its copy in the store of the cell.
  /// @return nothing if the disk has too little space besides the room already reserved
  std::shared_ptr<UploadPlace> reserve(std::uint64_t bytes);

 private:
  std::shared_ptr<UploadPromises> promises_;
};

}  // namespace lamina
