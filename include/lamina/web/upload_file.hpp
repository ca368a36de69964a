// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "lamina/web/http_message.hpp"
#include "lamina/web/multipart_reader.hpp"
#include "lamina/web/upload_room.hpp"

namespace lamina {

/// An upload that does not fit: beyond the limit (413) or the disk (507).
class UploadTooLarge : public std::exception {
 public:
  UploadTooLarge(int status, std::string message) : status_(status), message_(std::move(message)) {}
  int status() const { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  int status_;
  std::string message_;
};

/// A form as it comes in: the part `file` goes to the disk under a name nobody can guess, the other fields
/// into memory. The file is gone with this.
class UploadFile {
 public:
  /// @param folder  that it is written to
  /// @param most  bytes of the file
  /// @param place  that is noted to be filled
  UploadFile(std::string folder, const std::string& boundary, std::uint64_t most,
             std::shared_ptr<UploadPlace> place);
  ~UploadFile();
  UploadFile(const UploadFile&) = delete;
  UploadFile& operator=(const UploadFile&) = delete;

  /// @throws InvalidInput if it is no form, has two files, or a field of more than 4 KiB; UploadTooLarge
  void read(std::string_view piece);

  /// @throws InvalidInput if the form was cut off or had no file
  const ReceivedUpload& finish();

 private:
  struct Digest;
  void begin(const MultipartHead& head);
  void take(std::string_view piece);

  std::string folder_;
  std::uint64_t most_;
  MultipartReader reader_;
  ReceivedUpload received_;
  int descriptor_ = -1;
  bool is_in_file_ = false;
  std::string field_;
  std::unique_ptr<Digest> digest_;
  std::shared_ptr<UploadPlace> place_;
};

}  // namespace lamina
