// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/job_override.hpp"

#include <sstream>

namespace lamina {

const char* nameOf(OverrideKind kind) {
  switch (kind) {
    case OverrideKind::Feed:
      return "feed";
    case OverrideKind::Flow:
      return "flow";
    case OverrideKind::Power:
      return "power";
  }
  return "";
}

std::string overrideRefusal(OverrideKind kind, double share, const OverrideBounds& bounds) {
  if (share >= bounds.least && share <= bounds.most) return "";
  std::ostringstream text;
  text << nameOf(kind) << " is " << share << "; must be from " << bounds.least << " to " << bounds.most
       << ", 1 is as planned";
  return text.str();
}

}  // namespace lamina
