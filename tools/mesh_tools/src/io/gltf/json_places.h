// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace mesh_tools::io {

/// Finds values in a JSON text that is known to be sound, so that parts of it can be replaced and the rest stays as it
/// is.

/// The value that begins at `at`, or behind white space there; nothing at the end.
std::string_view json_value(std::string_view text, std::size_t at);

/// Calls `visit(key, value)` for each member of the object, in its order. Keys are as in the text, between the quotes.
template <class Visit>
void visit_members(std::string_view object, const Visit& visit);

/// Calls `visit(index, value)` for each element of the array.
template <class Visit>
void visit_elements(std::string_view array, const Visit& visit);

/// The value of a member; the last of several, as parsers have it. Nothing if there is none.
inline std::string_view json_member(std::string_view object, std::string_view key) {
  std::string_view found;
  visit_members(object, [&](std::string_view name, std::string_view value) {
    if (name == key) found = value;
  });
  return found;
}

namespace detail {
/// Where a text goes on behind white space, commas and colons.
std::size_t next_token(std::string_view text, std::size_t at);
inline std::size_t end_of(std::string_view text, std::string_view part) {
  return static_cast<std::size_t>(part.data() - text.data()) + part.size();
}
}  // namespace detail

template <class Visit>
void visit_members(std::string_view object, const Visit& visit) {
  if (object.empty() || object[0] != '{') return;
  for (std::size_t at = detail::next_token(object, 1); at < object.size() && object[at] == '"';) {
    const std::string_view key = json_value(object, at);
    const std::string_view value = json_value(object, detail::next_token(object, detail::end_of(object, key)));
    if (value.empty()) return;
    visit(key.substr(1, key.size() - 2), value);
    at = detail::next_token(object, detail::end_of(object, value));
  }
}

template <class Visit>
void visit_elements(std::string_view array, const Visit& visit) {
  if (array.empty() || array[0] != '[') return;
  std::size_t index = 0;
  for (std::size_t at = detail::next_token(array, 1); at < array.size() && array[at] != ']'; ++index) {
    const std::string_view value = json_value(array, at);
    if (value.empty()) return;
    visit(index, value);
    at = detail::next_token(array, detail::end_of(array, value));
  }
}

}  // namespace mesh_tools::io
