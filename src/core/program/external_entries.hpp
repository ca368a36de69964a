// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lamina {

/// Which axis of a controller an external joint is, and how it counts: value = sign · joint + zero.
struct ExternalEntry {
  std::string joint;     ///< external_1, ...
  std::size_t slot = 0;  ///< 0 for the first axis
  double sign = 1.0;
  double zero = 0.0;  ///< [mm, deg]
};

/// How a setting names the axes of a controller: a prefix with one of six characters behind it.
struct ExternalNaming {
  std::string setting;  ///< key, for errors
  std::string prefix;   ///< "eax_"
  char first = 'a';     ///< of the first axis
  std::string example;  ///< for errors

  std::string nameOf(std::size_t slot) const;
};

/// The entries of a text, as "external_1=eax_b, external_2=-eax_c+90", in its order.
/// @throws InvalidConfig naming the setting if one is no joint=axis, with a minus before and a zero behind
///   where there are any, or a joint or an axis stands twice
std::vector<ExternalEntry> externalEntries(const std::string& text, const ExternalNaming& naming);

}  // namespace lamina
