// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace lamina {

/// What messages quote of a file that is being read. Whoever has a file read need not be allowed to read it,
/// and hears what is wrong with it: so a file is quoted only once something was read that none but a file of
/// the kind expected holds. Every reader of files has one.
class Quotation {
 public:
  /// Something was read that makes the file one of the kind expected.
  void recognise() { is_recognised_ = true; }
  bool isRecognised() const { return is_recognised_; }

  /// The text between quotation marks: at most 40 characters, and ? for those that cannot be printed. Before
  /// `recognise`, words that say why it is not shown.
  std::string of(std::string_view text) const;

 private:
  bool is_recognised_ = false;
};

}  // namespace lamina
