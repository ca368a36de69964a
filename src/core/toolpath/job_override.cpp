// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/job_override.hpp"

#include <sstream>

namespace lamina {

const char* nameOf(JobOverride kind) {
  switch (kind) {
    case JobOverride::Feed:
      return "feed";
    case JobOverride::Flow:
      return "flow";
    case JobOverride::Power:
      return "power";
  }
  return "";
}

std::string overrideRefusal(JobOverride kind, double share, const OverrideBounds& bounds) {
  if (share >= bounds.least && share <= bounds.most) return "";
  std::ostringstream text;
  text << nameOf(kind) << " is " << share << "; must be from " << bounds.least << " to " << bounds.most
       << ", 1 is as planned";
  return text.str();
}

}  // namespace lamina
