// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/available_memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace lamina {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kKibibyte = 1024.0;

double machineMemory() {
  std::ifstream file("/proc/meminfo");
  std::string key;
  std::string rest;
  for (double kibibytes = 0.0; file >> key >> kibibytes && std::getline(file, rest);)
    if (key == "MemAvailable:") return kibibytes * kKibibyte;
  return kUnlimited;
}

/// The number in a file; unlimited if there is no such file or no number in it ("max").
double numberIn(const std::string& path) {
  std::ifstream file(path);
  double number = 0.0;
  return file >> number ? number : kUnlimited;
}

double groupMemory() {
  const std::string group = "/sys/fs/cgroup/memory.";
  const double most = numberIn(group + "max");
  return most == kUnlimited ? kUnlimited : std::max(0.0, most - numberIn(group + "current"));
}

}  // namespace

double availableMemory() { return std::min(machineMemory(), groupMemory()); }

double peakMemory() {
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) * kKibibyte : 0.0;
}

}  // namespace lamina
