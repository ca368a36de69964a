// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace lamina::cli {

/// For `CLI::Option::check` beside a range, which lets pass what is no number: "nan" is neither below nor
/// above its bounds.
/// @return what is wrong; empty if nothing is
inline std::string requireFinite(const std::string& text) {
  return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : text + " is not finite; expected a number";
}

}  // namespace lamina::cli
