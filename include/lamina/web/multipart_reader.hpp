// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The head of a part of a form.
struct MultipartHead {
  std::string name;  ///< of the field
  /// From `filename*`, if it is given, otherwise from `filename`; nothing if the part is no file.
  std::optional<std::string> filename;
};

/// Functions that are called for each part of a form, in the order of the parts.
struct MultipartHandlers {
  std::function<void(const MultipartHead&)> begin;
  std::function<void(std::string_view piece)> piece;
  std::function<void()> end;
};

/// The boundary in the header `Content-Type: multipart/form-data`; nothing if the type is another, or the
/// boundary is invalid or not 1 to 70 characters long.
std::optional<std::string> multipartBoundary(std::string_view content_type);

/// Reads a form (RFC 7578) piece by piece, keeping at most 16 KiB of it.
class MultipartReader {
 public:
  MultipartReader(const std::string& boundary, MultipartHandlers handlers);

  /// Reads the next piece of the body.
  /// @throws InvalidInput if it is no valid form: a part without name, a head of more than 8 KiB, more than
  ///   16 parts
  void read(std::string_view piece);

  /// Ends the form.
  /// @throws InvalidInput if it was cut off
  void finish() const;

 private:
  enum class Within : std::uint8_t { Preamble, Boundary, Head, Body, Epilogue };
  bool advance();
  bool skipPreamble();
  bool takeBoundary();
  bool takeHead();
  bool takeBody();

  std::string delimiter_;  ///< CR LF -- boundary
  MultipartHandlers handlers_;
  std::string held_;
  Within within_ = Within::Preamble;
  bool is_body_new_ = false;
  int parts_ = 0;
};

/// A file name that may be shown and stored: the last part of a path, without control characters and leading
/// dots, at most 120 bytes of whole UTF-8 characters; "program.gcode" if nothing is left.
std::string safeFileName(std::string_view name);

}  // namespace lamina
