// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "fail.h"
#include "fingerprint.h"

namespace tiles {
namespace {

using nlohmann::ordered_json;
using vcg_core::ParameterInfo;

constexpr int layout_version = 1;

ordered_json to_json(const Job& job) {
  const vcg_core::MethodInfo& method = vcg_core::method_info(job.method);
  ordered_json json = {{"method", method.name}};
  for (const ParameterInfo& row : method.parameters) {
    if (row.kind() == ParameterInfo::Kind::choice)
      json["parameters"][row.name] = row.text(job.parameters);
    else
      json["parameters"][row.name] = row.value(job.parameters);
  }
  json["weld_distance"] = job.limits.weld_distance;
  if (std::isfinite(job.limits.max_displacement)) json["max_displacement"] = job.limits.max_displacement;
  return json;
}

Job job_of(const ordered_json& json) {
  const vcg_core::MethodInfo& method = vcg_core::method_info(json.at("method").get<std::string>());
  Job job;
  job.method = method.method;
  job.parameters = method.defaults;
  for (const ParameterInfo& row : method.parameters) {
    const ordered_json& value = json.at("parameters").at(row.name);
    if (value.is_string())
      row.set_choice(job.parameters, value.get<std::string>());
    else
      row.set(job.parameters, value.get<double>());
  }
  job.limits.weld_distance = json.at("weld_distance");
  job.limits.max_displacement = json.value("max_displacement", std::numeric_limits<double>::infinity());
  return job;
}

ordered_json to_json(const vcg_core::GuidedWhole& whole) {
  const vcg_core::GuidedWhole::Testimony& t = whole.testimony;
  ordered_json json = {{"testimony", {t.opposed, t.expected, t.trusted, t.asked}},
                       {"noise", whole.noise},
                       {"correlated", whole.correlated},
                       {"medians", whole.medians}};
  if (whole.grid)
    json["voxels"] = {{"axis", whole.grid->axis},
                      {"first", whole.grid->first},
                      {"distance", whole.grid->distance},
                      {"odd_centres", whole.grid->odd_centres}};
  return json;
}

vcg_core::GuidedWhole guided_of(const ordered_json& json) {
  vcg_core::GuidedWhole whole;
  const ordered_json& t = json.at("testimony");
  whole.testimony = {t.at(0), t.at(1), t.at(2), t.at(3)};
  whole.noise = json.at("noise");
  whole.correlated = json.at("correlated");
  whole.medians = json.at("medians").get<std::vector<double>>();
  if (!json.contains("voxels")) return whole;
  const ordered_json& voxels = json.at("voxels");
  whole.grid.emplace();
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) whole.grid->axis[k][i] = voxels.at("axis").at(k).at(i);
    whole.grid->first[k] = voxels.at("first").at(k);
    whole.grid->distance[k] = voxels.at("distance").at(k);
  }
  whole.grid->odd_centres = voxels.at("odd_centres");
  return whole;
}

std::uint64_t id_of(const ordered_json& json) {
  Checksum sum;
  sum.add(json.dump());
  return sum.value();
}

[[noreturn]] void changed(const Plan& plan, const std::string& what) {
  fail(plan.input, what + " since the plan was made; make a new one");
}

}  // namespace

std::filesystem::path Plan::bucket_path(std::size_t tile) const { return folder / ("bucket_" + std::to_string(tile)); }

std::filesystem::path Plan::result_path(std::size_t tile) const { return folder / ("result_" + std::to_string(tile)); }

std::string plan_text(Plan& plan) {
  ordered_json json = {
      {"version", layout_version},
      {"input", plan.input.string()},
      {"input_size", plan.input_size},
      {"input_modified", plan.input_modified},
      {"input_samples", plan.input_samples},
      {"job", to_json(plan.job)},
      {"vertices", plan.vertices},
      {"faces", plan.faces},
      {"real_size", plan.real_size},
      {"normal_size", plan.normal_size},
      {"box_min", plan.box.min},
      {"box_max", plan.box.max},
      {"average_edge_length", plan.average_edge_length},
      {"reach", plan.reach},
      {"grid", {{"origin", plan.grid.origin()}, {"side", plan.grid.side()}, {"size", plan.grid.size()}}},
      {"vertices_of", plan.vertices_of}};
  for (const Cut::Node& node : plan.cut) json["cut"].push_back({node.axis, node.at, node.low, node.high});
  if (plan.guided) json["guided"] = to_json(*plan.guided);
  plan.id = id_of(json);
  json["id"] = plan.id;
  return json.dump(1) + "\n";
}

Plan read_plan(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "plan.json";
  if (!std::filesystem::exists(path)) fail(folder, "holds no plan; 'anisosmooth tiles plan' makes one");
  const InputFile file(path);
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  file.read(0, text.data(), text.size());
  Plan plan;
  try {
    ordered_json json = ordered_json::parse(text);
    plan.folder = folder;
    plan.id = json.at("id");
    json.erase("id");
    if (json.at("version") != layout_version) fail(path, "is of another version of this program; make the plan again");
    if (plan.id != id_of(json)) fail(path, "is damaged; make the plan again");
    plan.input = json.at("input").get<std::string>();
    plan.input_size = json.at("input_size");
    plan.input_modified = json.at("input_modified");
    plan.input_samples = json.at("input_samples");
    plan.job = job_of(json.at("job"));
    plan.vertices = json.at("vertices");
    plan.faces = json.at("faces");
    plan.real_size = json.at("real_size");
    plan.normal_size = json.at("normal_size");
    plan.box.min = json.at("box_min");
    plan.box.max = json.at("box_max");
    plan.average_edge_length = json.at("average_edge_length");
    plan.reach = json.at("reach");
    plan.grid = Grid(json.at("grid").at("origin").get<Point>(), json.at("grid").at("side"),
                     json.at("grid").at("size").get<std::array<std::uint32_t, 3>>());
    if (json.contains("guided")) plan.guided = guided_of(json.at("guided"));
    plan.vertices_of = json.at("vertices_of").get<std::vector<std::size_t>>();
    for (const ordered_json& node : json.at("cut"))
      plan.cut.push_back({node.at(0), node.at(1), node.at(2), node.at(3)});
  } catch (const nlohmann::json::exception&) {
    fail(path, "is damaged; make the plan again");
  }
  return plan;
}

LargeMesh open_input(const Plan& plan) {
  {
    const InputFile file(plan.input);
    if (file.size() != plan.input_size) changed(plan, "has another size than it had");
    if (file.modified() != plan.input_modified) changed(plan, "has been written to");
  }
  LargeMesh mesh(plan.input);
  if (sample_checksum(mesh.file(), mesh.header_size()) != plan.input_samples)
    changed(plan, "has other contents than it had");
  return mesh;
}

}  // namespace tiles
