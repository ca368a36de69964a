// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamina {

/// The text without white space at its ends; the same in every locale.
std::string_view trimmed(std::string_view text);

/// The text without the mark of UTF-8 (EF BB BF) that editors on Windows put at the start of a file.
std::string_view withoutUtf8Mark(std::string_view text);

/// The bytes of a file as text in UTF-8 or ASCII, without the mark of UTF-8.
/// @param source  names the file in errors
/// @throws FileError if they begin with the mark of UTF-16
std::string_view utf8Text(std::string_view bytes, const std::string& source);

/// The text with its ASCII letters small; the same in every locale.
std::string lowerCase(std::string_view text);

/// The suffix of a file's name, from its dot on, in small letters: ".ls" of "BOX.LS". Controllers and Windows
/// write it in capitals too.
std::string smallSuffix(const std::string& path);

/// The entries of a list with commas between them, without white space at their ends and without empty ones.
std::vector<std::string> listEntries(std::string_view list);

/// The names joined by the separator; empty if there are none.
std::string listed(const std::vector<std::string>& names, std::string_view separator = ", ");

/// The words of a text, separated by white space.
std::vector<std::string> splitIntoWords(const std::string& text);

/// A count of things as the subject of a sentence, with the verb: "1 layer was", "3 layers were".
/// @param noun  noun in the singular, with a plural in -s
std::string countedSubject(std::size_t count, const std::string& noun);

/// The words of a text, wrapped into lines of at most `longest_line` characters. A longer word has a line of
/// its own. A text without words gives one empty line.
std::vector<std::string> brokenInto(std::size_t longest_line, const std::string& text);

}  // namespace lamina
