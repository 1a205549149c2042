// SPDX-License-Identifier: GPL-3.0-or-later
#include <vcg_core/method.h>

#include <algorithm>

#include <vcg_core/errors.h>

#include "filters/catalogue.h"

namespace vcg_core {

const ParameterInfo* MethodInfo::find(const ParameterInfo::Member& member) const {
  const auto row = std::find_if(parameters.begin(), parameters.end(),
                                [&](const ParameterInfo& candidate) { return candidate.member == member; });
  return row == parameters.end() ? nullptr : &*row;
}

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> infos;
    for (const detail::Filter& filter : detail::catalogue()) infos.push_back(filter.info);
    return infos;
  }();
  return all;
}

const MethodInfo& method_info(Method method) { return detail::filter_of(method).info; }

const std::string& method_name(Method method) { return method_info(method).name; }

std::optional<Method> method_from_name(std::string_view name) {
  for (const MethodInfo& info : methods())
    if (info.name == name) return info.method;
  return std::nullopt;
}

const MethodInfo& method_info(std::string_view name) {
  if (const auto method = method_from_name(name)) return method_info(*method);
  std::string names;
  for (const MethodInfo& info : methods()) names += (names.empty() ? "" : ", ") + info.name;
  throw InvalidParameter("method is '" + std::string(name) + "'; allowed are " + names);
}

}  // namespace vcg_core
