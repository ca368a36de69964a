// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/upload_room.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "lamina/base/disk_space.hpp"
#include "lamina/web/upload_file.hpp"

namespace lamina {
namespace {

constexpr std::uint64_t kSpared = std::uint64_t{1} << 30;        // bytes of the disk that uploads leave
constexpr std::uint64_t kCheckedEach = std::uint64_t{16} << 20;  // bytes of an upload
constexpr std::uint64_t kCopies = 2;  // what is uploaded, and what the cell's store makes of it

}  // namespace

std::uint64_t freeForUploads(const std::string& folder) { return freeBytesOf(folder).value_or(0); }

struct UploadPromises {
  std::string folder;
  FreeBytes free_bytes;
  std::mutex mutex;
  std::uint64_t promised = 0;  // bytes that are still to be written

  bool isThereRoom(std::uint64_t more) const { return free_bytes(folder) >= kSpared + promised + more; }
};

UploadPlace::UploadPlace(std::shared_ptr<UploadPromises> promises, std::uint64_t bytes)
    : promises_(std::move(promises)), left_(bytes) {}

UploadPlace::~UploadPlace() {
  const std::lock_guard<std::mutex> lock(promises_->mutex);
  promises_->promised -= left_;
}

void UploadPlace::note(std::uint64_t written) {
  const std::lock_guard<std::mutex> lock(promises_->mutex);
  const std::uint64_t kept = std::min(written, left_);
  left_ -= kept;
  promises_->promised -= kept;
  unchecked_ += written;
  if (unchecked_ < kCheckedEach) return;
  unchecked_ = 0;
  if (!promises_->isThereRoom(0))
    throw UploadTooLarge(507, promises_->folder + ": the disk would have less than 1 GiB left");
}

UploadRoom::UploadRoom(std::string folder, FreeBytes free_bytes)
    : promises_(std::make_shared<UploadPromises>()) {
  promises_->folder = std::move(folder);
  promises_->free_bytes = std::move(free_bytes);
}

std::shared_ptr<UploadPlace> UploadRoom::reserve(std::uint64_t bytes) {
  const std::uint64_t wanted = kCopies * bytes;
  {
    const std::lock_guard<std::mutex> lock(promises_->mutex);
    if (!promises_->isThereRoom(wanted)) return nullptr;
    promises_->promised += wanted;
  }
  return std::make_shared<UploadPlace>(promises_, wanted);
}

}  // namespace lamina
