// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/picture/html.hpp"

#include <charconv>
#include <cstdint>

#include "lamina/base/base64.hpp"

namespace lamina {
namespace {

constexpr char kStyle[] = R"(
  body { font: 15px/1.5 "DejaVu Sans", Helvetica, Arial, sans-serif; color: #24272b; background: #fff;
         max-width: 1120px; margin: 2.5rem auto; padding: 0 1.5rem; }
  h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .6rem; }
  h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; padding-bottom: .25rem; border-bottom: 1px solid #d9dde1; }
  p { margin: .5rem 0; max-width: 52rem; white-space: pre-line; }
  .wide { overflow-x: auto; }
  table { border-collapse: collapse; font-size: .86rem; margin: .6rem 0; }
  th, td { padding: .28rem .7rem; text-align: left; border-bottom: 1px solid #e6e9ec; vertical-align: top; }
  th { font-weight: 600; color: #4a5058; border-bottom: 2px solid #c3c9cf; }
  td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  tr.marked td { background: #eef6f0; font-weight: 600; }
  .pictures { margin: 0 -.4rem; }
  .pictures img { width: 520px; max-width: 100%; margin: .4rem; border: 1px solid #e6e9ec; }
  @media print { body { margin: 0; max-width: none; font-size: 11px; } table { font-size: .78rem; }
    .wide { overflow-x: visible; } .pictures img { width: 46%; } h2, tr, img { break-inside: avoid; }
    h2 { break-after: avoid; } tr.marked td { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
)";

/// Length of the UTF-8 sequence at a place; 0 if there is none.
std::size_t sequenceAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) return 0;
  std::uint32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(at + i) & 0x3FU);
  }
  const bool is_too_long = length == 3 ? code < 0x800U : length == 4 && code < 0x10000U;
  return is_too_long || code > 0x10FFFFU || (code >= 0xD800U && code <= 0xDFFFU) ? 0 : length;
}

/// May be broken between the words of a name such as gain_mean or infill.angle_deg.
std::string breakable(const std::string& name) {
  std::string broken;
  for (const char c : name) broken += c == '_' || c == '.' ? std::string(1, c) + "<wbr>" : std::string(1, c);
  return broken;
}

std::string escapedCharacter(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      break;
  }
  const bool is_shown = static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t';
  return is_shown && c != 0x7F ? std::string(1, c) : "?";
}

bool isNumber(const std::string& text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

}  // namespace

std::string escapedHtml(std::string_view text) {
  std::string escaped;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = sequenceAt(text, at);
    if (length <= 1)
      escaped += length == 1 ? escapedCharacter(text[at]) : "?";
    else
      escaped += text.substr(at, length);
    at += length == 0 ? 1 : length;
  }
  return escaped;
}

void HtmlPage::heading(const std::string& text) { body_ += "<h2>" + escapedHtml(text) + "</h2>\n"; }

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + escapedHtml(text) + "</p>\n"; }

void HtmlPage::table(const HtmlTable& table) {
  if (table.rows.empty()) return;
  body_ += "<div class=\"wide\"><table>\n<thead><tr>";
  for (const std::string& name : table.head) body_ += "<th>" + breakable(escapedHtml(name)) + "</th>";
  body_ += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    body_ += i < table.marked_rows ? "<tr class=\"marked\">" : "<tr>";
    for (const std::string& cell : table.rows[i])
      body_ += (isNumber(cell) ? "<td class=\"number\">" : "<td>") + escapedHtml(cell) + "</td>";
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void HtmlPage::pictures(const std::vector<std::string>& pngs, const std::vector<std::string>& descriptions) {
  if (pngs.empty()) return;
  body_ += "<div class=\"pictures\">\n";
  for (std::size_t i = 0; i < pngs.size(); ++i)
    body_ += "<img alt=\"" + escapedHtml(descriptions.at(i)) + "\" src=\"data:image/png;base64," +
             base64(pngs[i]) + "\">\n";
  body_ += "</div>\n";
}

void HtmlPage::drawing(const std::string& svg) { body_ += "<div class=\"wide\">" + svg + "</div>\n"; }

std::string HtmlPage::text() const {
  const std::string title = escapedHtml(title_);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n" +
         body_ + "</body>\n</html>\n";
}

}  // namespace lamina
