// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "journal_care.hpp"

#include <ros/ros.h>

#include <chrono>
#include <exception>
#include <utility>

#include "lamina/base/disk_space.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr int kDiskLow = 7002;
constexpr int kAuditBroken = 9003;
constexpr double kLookInterval = 5.0;     // [s]
constexpr double kRetryInterval = 600.0;  // [s] of a copy that could not be made
constexpr double kGibibyte = 1024.0 * 1024 * 1024;

std::string auditFault(const CellJournal& journal) {
  const auto bad = journal.firstBadAudit();
  if (!bad) return "";
  return "row " + std::to_string(*bad) + " of the audit was edited, removed or added";
}

}  // namespace

JournalCare::JournalCare(const CellJournal& journal, std::string folder, const JournalCareSettings& settings)
    : folder_(std::move(folder)), settings_(settings), broken_audit_(auditFault(journal)) {}

std::vector<UnmetGuard> JournalCare::againstStart() const {
  if (broken_audit_.empty()) return {};
  return {{kAuditBroken, broken_audit_ + "; keep the journal as it is, and begin a new one elsewhere"}};
}

std::vector<CareAlarm> JournalCare::look(CellTime now) {
  std::vector<CareAlarm> alarms;
  if (now.steady_s - looked_s_ < kLookInterval) return alarms;
  looked_s_ = now.steady_s;
  if (!broken_audit_.empty() && !std::exchange(is_audit_reported_, true))
    alarms.push_back({kAuditBroken, 0.0, broken_audit_, false});
  for (CareAlarm& alarm : lookAtDisk()) alarms.push_back(std::move(alarm));
  followCopy(now);
  return alarms;
}

std::vector<CareAlarm> JournalCare::lookAtDisk() {
  const auto free_bytes = freeBytesOf(folder_);
  const double free_gib = static_cast<double>(free_bytes.value_or(0)) / kGibibyte;
  const bool was_low = std::exchange(is_disk_low_, free_gib < settings_.least_free_gib);
  if (was_low == is_disk_low_) return {};
  const std::string left =
      free_bytes ? "has " + numberText(free_gib) + " GiB left" : "does not say what it has left";
  return {
      {kDiskLow, free_gib,
       "the journal's disk " + left + "; expected at least " + numberText(settings_.least_free_gib) + " GiB",
       was_low}};
}

void JournalCare::followCopy(CellTime now) {
  using namespace std::chrono_literals;
  if (copy_.valid()) {
    if (copy_.wait_for(0s) != std::future_status::ready) return;
    const std::string fault = copy_.get();
    if (!fault.empty()) ROS_ERROR_STREAM("the journal was not copied: " << fault);
    return;
  }
  const std::string due = copyDue(folder_, now.utc_s, settings_.copies);
  if (due.empty() || now.steady_s - tried_s_ < kRetryInterval) return;
  tried_s_ = now.steady_s;
  copy_ =
      std::async(std::launch::async, [folder = folder_, due, kept = settings_.copies.kept]() -> std::string {
        try {
          copyJournal(folder, due, kept);
        } catch (const std::exception& error) {
          return error.what();
        }
        return "";
      });
}

}  // namespace lamina
