// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace lamina::cli {

/// For `CLI::Option::check` besides a range check, which accepts "nan": it is neither below nor above the
/// bounds.
/// @return the fault; empty if there is none
inline std::string requireFinite(const std::string& text) {
  return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : text + " is not finite; expected a number";
}

}  // namespace lamina::cli
