#include <vcg_core/method.h>

#include <algorithm>

#include "filters/catalogue.h"

namespace vcg_core {

bool MethodInfo::uses(std::string_view parameter) const {
  return std::find(parameters.begin(), parameters.end(), parameter) != parameters.end();
}

const std::vector<MethodInfo>& methods() {
  static const std::vector<MethodInfo> all = [] {
    std::vector<MethodInfo> infos;
    for (const detail::FilterEntry& entry : detail::filter_table()) infos.push_back(entry.info);
    return infos;
  }();
  return all;
}

const MethodInfo& method_info(Method method) { return detail::filter_entry(method).info; }

const std::string& method_name(Method method) { return method_info(method).name; }

std::optional<Method> method_from_name(std::string_view name) {
  for (const MethodInfo& info : methods())
    if (info.name == name) return info.method;
  return std::nullopt;
}

}  // namespace vcg_core
