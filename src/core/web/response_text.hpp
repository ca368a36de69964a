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

/// Whether the client shows errors as they are: slicers do that send a file by OctoPrint's interface, unless
/// they ask for JSON by `Accept`.
bool isShownAsText(const HttpHead& request);

/// An error as its message alone; any other answer as it is. Its type has no parameter, because Cura shows
/// the text of no other type than "text/plain", of which it shows 100 characters.
WebResponse errorAsText(WebResponse response);

}  // namespace lamina
