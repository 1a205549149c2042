// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <system_error>

#include "formats.h"

namespace mesh_tools::io {
namespace {
/// Within a line: a blank, or one of \t \v \f \r, which with \n stand side by side.
bool is_space(char c) {
  if (static_cast<unsigned char>(c) > ' ') return false;  // nearly all, by one comparison
  return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}
}  // namespace

FirstLine first_line(std::string_view text) {
  constexpr std::size_t window =
      1024;  // a text may have ends of one kind only: the other is not looked for in all of it
  std::size_t length = text.size();
  for (std::size_t start = 0; start < text.size() && length == text.size(); start += window) {
    std::size_t end = std::min(window, text.size() - start);
    for (const char c : {'\n', '\r'})
      if (const void* const found = std::memchr(text.data() + start, c, end)) {
        end = static_cast<std::size_t>(static_cast<const char*>(found) - text.data()) - start;
        length = start + end;
      }
  }
  const bool is_pair = text.substr(length, 2) == "\r\n";
  return {text.substr(0, length), std::min(text.size(), length + (is_pair ? 2 : 1))};
}

LineReader::LineReader(std::string_view text, const std::filesystem::path& path, Comments comments)
    : rest_(text.substr(byte_order_mark(text))), path_(path), comments_(comments) {}

std::string_view LineReader::take_line(const std::vector<std::string_view>& words) {
  auto [line, size] = first_line(rest_);
  rest_.remove_prefix(size);
  ++line_;
  line = without_comment(line, words.empty() ? std::string_view() : words[0]);  // a backslash in it joins nothing
  while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
  return line;
}

std::string_view LineReader::without_comment(std::string_view line, std::string_view statement) const {
  const std::size_t comment = line.find('#');
  if (comment == line.npos || comments_ == Comments::anywhere) return line.substr(0, comment);
  std::size_t start = 0;
  while (is_space(line[start])) ++start;
  if (start == comment) return {};
  if (statement.empty()) {
    std::size_t end = start;
    while (end < line.size() && !is_space(line[end])) ++end;
    statement = line.substr(start, end - start);
  }
  static constexpr std::string_view of_numbers[] = {"v", "vt", "vn", "vp", "f", "l", "p", "s", "Kd", "d", "Tr"};
  if (std::find(std::begin(of_numbers), std::end(of_numbers), statement) != std::end(of_numbers))
    return line.substr(0, comment);
  const bool may_end_in_comment = line.find(" #") != line.npos || line.find("\t#") != line.npos;
  while (may_end_in_comment && (is_space(line.back()) || line.back() == '\\')) line.remove_suffix(1);
  return line;
}

void LineReader::take_words(std::string_view line, std::vector<std::string_view>& words) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at < end) {
    while (at < end && is_space(*at)) ++at;
    const char* const start = at;
    while (at < end && !is_space(*at)) ++at;
    if (at > start) words.emplace_back(start, static_cast<std::size_t>(at - start));
  }
}

bool LineReader::next(std::vector<std::string_view>& words) {
  words.clear();
  bool continued = false;
  while ((continued || words.empty()) && !rest_.empty()) {
    std::string_view line = take_line(words);
    continued = !line.empty() && line.back() == '\\';
    if (continued) line.remove_suffix(1);
    take_words(line, words);
  }
  return !words.empty();
}

void LineReader::fail(const std::string& what) const { fail_at_line(path_, line_, what); }

double LineReader::number(std::string_view word) const {
  double value = 0;
  const char* first = word.data();
  const char* last = first + word.size();
  if (first != last && *first == '+') ++first;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
  if (error != std::errc() || end != last || first == last) fail("'" + printable(word) + "' is not a number");
  return value;
}

std::int64_t LineReader::integer(std::string_view word) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) fail("'" + printable(word) + "' is not a whole number");
  return value;
}

}  // namespace mesh_tools::io
