// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina::test {

/// Keys of all settings that the core describes.
std::vector<std::string> coreKeys();

/// A setting whose effect another test shows, and the word for it there.
struct TestedElsewhere {
  const char* key;
  const char* file;  ///< under test/
  const char* word;
};
const std::vector<TestedElsewhere>& testedElsewhere();

}  // namespace lamina::test
