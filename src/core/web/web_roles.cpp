// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/web/web_roles.hpp"

#include <array>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::array kRoles = {WebRole::Viewer, WebRole::Sender, WebRole::Operator, WebRole::Maintenance};

}  // namespace

const char* toString(WebRole role) {
  switch (role) {
    case WebRole::Viewer:
      return "viewer";
    case WebRole::Sender:
      return "sender";
    case WebRole::Operator:
      return "operator";
    case WebRole::Maintenance:
      return "maintenance";
  }
  return "unknown";
}

const char* toString(WebRight right) {
  switch (right) {
    case WebRight::None:
      return "none";
    case WebRight::SeeState:
      return "see state";
    case WebRight::SeeAll:
      return "see all";
    case WebRight::Upload:
      return "upload";
    case WebRight::Hold:
      return "hold";
    case WebRight::Operate:
      return "operate";
    case WebRight::Maintain:
      return "maintain";
  }
  return "unknown";
}

WebRole webRole(const std::string& name) {
  for (const WebRole role : kRoles)
    if (name == toString(role)) return role;
  throw InvalidInput("role is '" + name + "'; expected viewer, sender, operator or maintenance");
}

bool mayDo(WebRole role, WebRight right) {
  switch (right) {
    case WebRight::None:
    case WebRight::SeeState:
      return true;
    case WebRight::SeeAll:
      return role != WebRole::Sender;
    case WebRight::Upload:
      return role != WebRole::Viewer;
    case WebRight::Hold:
    case WebRight::Operate:
      return role == WebRole::Operator || role == WebRole::Maintenance;
    case WebRight::Maintain:
      return role == WebRole::Maintenance;
  }
  return false;
}

}  // namespace lamina
