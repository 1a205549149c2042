// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "splice.h"

namespace mesh_tools::io {

/// Whether two numbers need no telling apart in a file.
template <class Number>
bool is_same_number(Number a, Number b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// A copy of a text in which words are replaced, from its beginning to its end, written part by part.
class TextSplicer {
 public:
  /// Both are referred to, not copied.
  TextSplicer(std::string_view text, const Write& write) : text_(text), write_(write) {}

  /// @param word  a part of the text, behind all that were replaced before
  void replace(std::string_view word, std::string_view by) {
    const auto at = static_cast<std::size_t>(word.data() - text_.data());
    part_.append(text_, done_, at - done_).append(by);
    done_ = at + word.size();
    if (part_.size() >= part_size) write_part();
  }

  /// The same with the shortest text that gives a number of this precision back. A word that stands for the number as
  /// it is stays.
  template <class Real>
  void replace_number(std::string_view word, Real before, Real now) {
    if (is_same_number(before, now)) return;
    char digits[64];
    const char* const end = std::to_chars(digits, digits + sizeof digits, now).ptr;
    replace(word, {digits, static_cast<std::size_t>(end - digits)});
  }

  /// Writes the rest.
  void finish() {
    write_part();
    write_(text_.substr(done_));
    done_ = text_.size();
  }

 private:
  static constexpr std::size_t part_size = std::size_t(1) << 17;

  void write_part() {
    write_(part_);
    part_.clear();
  }

  std::string_view text_;
  const Write& write_;
  std::size_t done_ = 0;  // so much of the text is written, or in the part
  std::string part_;
};

}  // namespace mesh_tools::io
