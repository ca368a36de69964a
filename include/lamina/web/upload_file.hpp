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

/// Error of an upload that is larger than the limit (status 413) or than the disk allows (507).
class UploadTooLarge : public std::exception {
 public:
  UploadTooLarge(int status, std::string message) : status_(status), message_(std::move(message)) {}
  int status() const { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  int status_;
  std::string message_;
};

/// Receives the form of an upload: the part with a file name is written to the disk under an unpredictable
/// name, the other fields are kept in memory. The file is deleted with this object.
class UploadFile {
 public:
  /// @param folder  in which the file is written
  /// @param most   greatest size of the file [bytes]
  /// @param place  reserved room on the disk, from which written bytes are taken
  UploadFile(std::string folder, const std::string& boundary, std::uint64_t most,
             std::shared_ptr<UploadPlace> place);
  ~UploadFile();
  UploadFile(const UploadFile&) = delete;
  UploadFile& operator=(const UploadFile&) = delete;

  /// Reads the next piece of the body.
  /// @throws InvalidInput if it is no valid form, has two files, or has a field of more than 4 KiB
  /// @throws UploadTooLarge; FileError if the file cannot be made
  void read(std::string_view piece);

  /// Ends the upload.
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
