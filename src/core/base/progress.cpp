// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/progress.hpp"

#include "lamina/base/error.hpp"

namespace lamina {

void throwIfCancelled(const Progress& progress, const std::string& stage) {
  if (progress.isCancelled()) throw Cancelled("cancelled during " + stage);
}

}  // namespace lamina
