// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesh_tools::io {

/// Where '#' begins a comment: anywhere, or not where a name may stand, which may hold a '#' itself.
enum class Comments { anywhere, outside_names };

/// Splits a text into lines and lines into words, which are parts of the text. Comments and empty lines are passed
/// over, and so is a byte order mark; a backslash at the end joins a line with the next. Lines end in LF, CR LF or CR.
class LineReader {
 public:
  /// Both are referred to or copied as they are; the text is not copied.
  /// @param comments  outside_names: a '#' behind a statement's first letters is part of a name, unless the statement
  ///                  is one of numbers
  LineReader(std::string_view text, const std::filesystem::path& path, Comments comments = Comments::anywhere);

  /// The words of the next line that has any; false at the end.
  bool next(std::vector<std::string_view>& words);

  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& what) const;

  /// Numbers in full or FileError with the line and the word.
  double number(std::string_view word) const;
  std::int64_t integer(std::string_view word) const;

 private:
  std::string_view take_line(const std::vector<std::string_view>& words);
  std::string_view without_comment(std::string_view line, std::string_view statement) const;
  static void take_words(std::string_view line, std::vector<std::string_view>& words);

  std::string_view rest_;
  std::filesystem::path path_;
  Comments comments_;
  std::size_t line_ = 0;
};

/// How many bytes a UTF-8 byte order mark at the beginning of a text takes: 3 or 0.
inline std::size_t byte_order_mark(std::string_view text) { return text.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0; }

/// The first line of a text without what ends it, and how many bytes both take. Lines end in LF, CR LF or CR.
struct FirstLine {
  std::string_view line;
  std::size_t size;
};
FirstLine first_line(std::string_view text);

/// Words that are parts of one line, from the first to the last of them, with the white space between.
inline std::string_view span(const std::vector<std::string_view>& words, std::size_t first) {
  const char* const end = words.back().data() + words.back().size();
  return {words[first].data(), static_cast<std::size_t>(end - words[first].data())};
}

/// The shortest text that gives the same double back; so a float is the same number to readers of either precision.
inline void append_number(std::string& text, double value) {
  char digits[64];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline void append_whole(std::string& text, std::uint64_t value) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

}  // namespace mesh_tools::io
