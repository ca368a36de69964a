// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refusal_text.hpp"

namespace lamina {

std::string refusalText(const RequestName& request, const Failure& failure) {
  const std::string subject = request.subject.empty() ? "nothing named" : "'" + request.subject + "'";
  const std::string output = request.output.empty() ? "" : " into '" + request.output + "'";
  return "cannot " + request.verb + " " + subject + output + ": " + toString(failure.code) + ": " +
         failure.message;
}

}  // namespace lamina
