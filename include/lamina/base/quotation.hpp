// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace lamina {

/// Text of a file being read that messages may quote. A user who lets a service read a file may have no right
/// to read it, but sees the messages about it. Therefore a file is quoted only after something was read in it
/// that only a file of the expected kind contains. Every reader of files has such an object.
class Quotation {
 public:
  /// States that something was read that only a file of the expected kind contains.
  void recognise() { is_recognised_ = true; }
  bool isRecognised() const { return is_recognised_; }

  /// The text between quotation marks: at most 40 characters, with ? for those that cannot be printed. Before
  /// `recognise`, words that state why it is not shown.
  std::string of(std::string_view text) const;

 private:
  bool is_recognised_ = false;
};

}  // namespace lamina
