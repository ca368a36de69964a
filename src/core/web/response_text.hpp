// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/web/http_message.hpp"

namespace lamina {

/// The head of an answer as it is sent, up to the empty line, including the headers that all answers have.
/// @param is_kept  whether another request may follow on the connection
std::string headText(const WebResponse& response, bool is_kept);

/// The answer to a request that is not passed to any route.
WebResponse plainError(int status, const std::string& code, const std::string& message);

/// Whether the client shows errors unchanged. Slicers do that send a file through OctoPrint's interface,
/// unless they request JSON by `Accept`.
bool isShownAsText(const HttpHead& request);

/// An error as its message alone; any other answer unchanged. The type is "text/plain" without a parameter:
/// Cura shows the text of no other type. Cura shows the first 100 characters.
WebResponse errorAsText(WebResponse response);

}  // namespace lamina
