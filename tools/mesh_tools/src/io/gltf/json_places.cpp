// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_places.h"

#include <algorithm>

namespace mesh_tools::io {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Behind the quote that ends the string that begins at `at`.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

}  // namespace

std::size_t detail::next_token(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_space(text[at]) || text[at] == ',' || text[at] == ':')) ++at;
  return at;
}

std::string_view json_value(std::string_view text, std::size_t at) {
  while (at < text.size() && is_space(text[at])) ++at;
  const std::size_t start = at;
  if (at == text.size()) return {};
  if (text[at] == '"') return text.substr(start, end_of_string(text, at) - start);
  if (text[at] != '{' && text[at] != '[') {
    while (at < text.size() && !is_space(text[at]) && text[at] != ',' && text[at] != ']' && text[at] != '}') ++at;
    return text.substr(start, at - start);
  }
  std::size_t depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"') {
      at = end_of_string(text, at);
      continue;
    }
    ++at;
    if (c == '{' || c == '[') ++depth;
    if ((c == '}' || c == ']') && --depth == 0) break;
  }
  return text.substr(start, at - start);
}

}  // namespace mesh_tools::io
