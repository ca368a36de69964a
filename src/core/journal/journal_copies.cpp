// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/journal_copies.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "journal/database.hpp"
#include "lamina/base/utc_time.hpp"

namespace lamina {
namespace {

constexpr char kCopies[] = "copies";
constexpr char kPrefix[] = "cell-";

/// Names in the order of their days; none of a folder that cannot be read to its end.
std::vector<std::filesystem::path> copiesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> copies;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.rfind(kPrefix, 0) == 0 && entry->path().extension() == ".db") copies.push_back(entry->path());
  }
  if (error) return {};
  std::sort(copies.begin(), copies.end());
  return copies;
}

}  // namespace

std::string copyDue(const std::string& folder, double utc_s, const JournalCopySettings& settings) {
  if (settings.hour < 0) return "";
  // A day lasts from its hour to the same hour of the next one.
  const std::string day = utcText(utc_s - 3600.0 * settings.hour, "%Y-%m-%d");
  const std::string name = std::string(kCopies) + '/' + kPrefix + day + ".db";
  // Where nobody may look, the copy is due, and says why it cannot be made.
  std::error_code error;
  return std::filesystem::exists(std::filesystem::path(folder) / name, error) ? "" : name;
}

void copyJournal(const std::string& folder, const std::string& name, int kept) {
  const std::filesystem::path target = std::filesystem::path(folder) / name;
  const std::string begun = target.string() + ".part";
  std::error_code error;
  std::filesystem::create_directories(target.parent_path(), error);
  std::filesystem::remove(begun, error);
  try {
    Database::toRead(folder + "/cell.db").copyTo(begun);
  } catch (const Error&) {
    std::filesystem::remove(begun, error);
    std::filesystem::remove(begun + "-journal", error);
    throw;
  }
  std::filesystem::rename(begun, target, error);
  if (error) throw FileError(target.string() + ": cannot be named: " + error.message());
  std::vector<std::filesystem::path> copies = copiesIn(target.parent_path());
  const auto surplus = static_cast<std::ptrdiff_t>(copies.size()) - std::max(1, kept);
  for (std::ptrdiff_t i = 0; i < surplus; ++i)
    std::filesystem::remove(copies[static_cast<std::size_t>(i)], error);
}

}  // namespace lamina
