// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/output_files.hpp"

#include <algorithm>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

namespace fs = std::filesystem;

fs::path resolved(const std::string& path) {
  std::error_code unknown;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), unknown);
  return unknown ? fs::path(path).lexically_normal() : whole;
}

}  // namespace

bool isSameFile(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return false;
  std::error_code missing;
  return fs::equivalent(one, other, missing) || resolved(one) == resolved(other);
}

void requireApart(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const std::string& input : inputs)
      if (isSameFile(outputs[i], input))
        throw InvalidInput("output '" + outputs[i] + "' is the file that is read, '" + input +
                           "'; expected another one");
    for (std::size_t j = 0; j < i; ++j)
      if (isSameFile(outputs[i], outputs[j]))
        throw InvalidInput("output '" + outputs[i] + "' is also written as '" + outputs[j] +
                           "'; expected another one");
  }
}

void requireWritableFile(const std::string& output) {
  if (!output.empty()) const AtomicFile tried(output);
}

void requireSuffix(const std::string& output, const std::vector<std::string>& suffixes) {
  const std::string suffix = fs::path(output).extension().string();
  if (output.empty() || std::find(suffixes.begin(), suffixes.end(), suffix) != suffixes.end()) return;
  throw InvalidInput("'" + output + "' cannot be written in that format; its suffix must be " +
                     (suffixes.size() > 1 ? "one of " : "") + listed(suffixes));
}

}  // namespace lamina
