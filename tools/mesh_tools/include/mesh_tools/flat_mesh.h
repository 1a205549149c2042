// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <vcg/space/color4.h>
#include <vcg/space/point3.h>

namespace mesh_tools {

/// How many digits numbers have.
enum class Precision { single_precision, double_precision };

/// Points or directions in one flat array of numbers, three each, in single or double precision.
class Points {
 public:
  Points() = default;
  explicit Points(Precision precision) : precision_(precision) {}

  Precision precision() const { return precision_; }
  std::size_t size() const { return (is_single() ? single_.size() : double_.size()) / 3; }
  bool empty() const { return size() == 0; }
  void resize(std::size_t size) { is_single() ? single_.resize(3 * size) : double_.resize(3 * size); }
  void reserve(std::size_t size) { is_single() ? single_.reserve(3 * size) : double_.reserve(3 * size); }

  vcg::Point3d operator[](std::size_t i) const {
    return is_single() ? vcg::Point3d(single_[3 * i], single_[3 * i + 1], single_[3 * i + 2])
                       : vcg::Point3d(double_[3 * i], double_[3 * i + 1], double_[3 * i + 2]);
  }
  double number(std::size_t i, int k) const {
    const std::size_t at = 3 * i + static_cast<std::size_t>(k);
    return is_single() ? static_cast<double>(single_[at]) : double_[at];
  }
  /// Rounded to the precision.
  void set(std::size_t i, int k, double number) {
    const std::size_t at = 3 * i + static_cast<std::size_t>(k);
    if (is_single())
      single_[at] = static_cast<float>(number);
    else
      double_[at] = number;
  }
  void set(std::size_t i, const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k) set(i, k, p[k]);
  }
  void push_back(const vcg::Point3d& p) {
    for (int k = 0; k < 3; ++k)
      if (is_single())
        single_.push_back(static_cast<float>(p[k]));
      else
        double_.push_back(p[k]);
  }

  /// The numbers; null in the other precision.
  const float* floats() const { return is_single() ? single_.data() : nullptr; }
  float* floats() { return is_single() ? single_.data() : nullptr; }
  double* doubles() { return is_single() ? nullptr : double_.data(); }

 private:
  bool is_single() const { return precision_ == Precision::single_precision; }

  Precision precision_ = Precision::double_precision;
  std::vector<float> single_;
  std::vector<double> double_;
};

/// A triangle mesh of flat arrays: places, faces, and of all else only what a file has. What it has not is an empty
/// array; otherwise there is one entry for each vertex, or for each face.
struct FlatMesh {
  struct TextureCoordinate {
    float u = std::numeric_limits<float>::quiet_NaN(), v = 0;  ///< a face with a NaN has no texture
  };

  Points position;
  std::vector<std::array<std::uint32_t, 3>> face;
  std::vector<std::array<std::uint32_t, 2>> edge;

  Points vertex_normal;
  std::vector<vcg::Color4b> vertex_color;
  std::vector<double> vertex_quality;
  std::vector<std::int32_t> vertex_flags;  ///< vcglib's bits
  std::vector<float> vertex_radius;
  std::vector<TextureCoordinate> vertex_texture;

  Points face_normal;
  std::vector<vcg::Color4b> face_color;
  std::vector<double> face_quality;
  std::vector<std::int32_t> face_flags;
  std::vector<std::array<TextureCoordinate, 3>> wedge_texture;
  std::vector<std::int16_t> face_page;  ///< which texture

  std::vector<std::string> textures;

  std::size_t vertices() const { return position.size(); }
};

/// vcglib's bit of the flags that marks what is selected.
constexpr std::int32_t selected_flag = 0x20;

}  // namespace mesh_tools
