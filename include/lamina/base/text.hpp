// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// Without white space at its ends; whatever the locale.
std::string_view trimmed(std::string_view text);

/// One after the other with the separator between them; empty if there are none.
std::string listed(const std::vector<std::string>& names, std::string_view separator = ", ");

/// Without the white space between them.
std::vector<std::string> splitIntoWords(const std::string& text);

/// So many things as the subject of a sentence: "1 layer was", "3 layers were".
/// @param noun  of one, whose plural takes an s
std::string countedSubject(std::size_t count, const std::string& noun);

/// The words of a text in lines of at most that many characters; a longer word has a line of its own. One
/// empty line if there are no words.
std::vector<std::string> brokenInto(std::size_t longest_line, const std::string& text);

}  // namespace lamina
