#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_tools::io {

/// Splits a text into lines and lines into words, which are parts of the text. Comments ('#' to the end of the line)
/// and empty lines are passed over; a backslash at the end joins a line with the next.
class LineReader {
 public:
  LineReader(std::string_view text, const std::filesystem::path& path) : rest_(text), path_(path) {}

  /// The words of the next line that has any; false at the end.
  bool next(std::vector<std::string_view>& words);

  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& what) const;

  /// Numbers in full or FileError with the line and the word.
  double number(std::string_view word) const;
  std::int64_t integer(std::string_view word) const;

 private:
  std::string_view take_line();
  static void take_words(std::string_view line, std::vector<std::string_view>& words);

  std::string_view rest_;
  std::filesystem::path path_;
  std::size_t line_ = 0;
};

/// The shortest text that gives the same double back; so a float is the same number to readers of either precision.
inline void append_number(std::string& text, double value) {
  char digits[64];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace mesh_tools::io
