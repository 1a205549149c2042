#include "text.h"

#include "formats.h"

namespace mesh_tools::io {
namespace {
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
}  // namespace

std::string_view LineReader::take_line() {
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  line = line.substr(0, line.find('#'));  // a backslash in a comment joins nothing
  while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
  return line;
}

void LineReader::take_words(std::string_view line, std::vector<std::string_view>& words) {
  std::size_t i = 0;
  while (i < line.size()) {
    while (i < line.size() && is_space(line[i])) ++i;
    const std::size_t start = i;
    while (i < line.size() && !is_space(line[i])) ++i;
    if (i > start) words.push_back(line.substr(start, i - start));
  }
}

bool LineReader::next(std::vector<std::string_view>& words) {
  words.clear();
  bool continued = false;
  while ((continued || words.empty()) && !rest_.empty()) {
    std::string_view line = take_line();
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
