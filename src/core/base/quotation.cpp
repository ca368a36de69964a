// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/quotation.hpp"

namespace lamina {

std::string Quotation::of(std::string_view text) const {
  constexpr std::size_t kLongest = 40;
  if (!is_recognised_) return "text that is not quoted, as nothing before it in the file is of this format";
  std::string shown;
  for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace lamina
