// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <mesh_tools/flat_mesh.h>

#include "large_pages.h"

namespace mesh_tools::io {

/// Gives triangles common vertices: corners at exactly the same place become one vertex, in the order of the file.
///
/// An open hash table, which is larger than the processor's caches. So corners come in blocks: the memory that all of a
/// block will need is asked for before the first is looked up.
class VertexMerger {
 public:
  static constexpr std::size_t largest_block = 96;

  /// @param corners  how many there will be
  /// @param places   where vertices are added, in single precision
  VertexMerger(std::size_t corners, Points& places) : places_(places) {
    // Most meshes have a vertex for six corners: with them the table becomes half full, with others it grows.
    std::size_t room = least_room;
    while (room < corners / 3) room *= 2;
    make_room(room);
    places_.reserve(corners / 6 + 8);
    wish_for_large_pages(places_.floats(), (corners / 6 + 8) * 3 * sizeof(float));
  }

  /// Finds the vertices of corners, at most `largest_block`.
  void merge(const vcg::Point3f* corner, std::size_t count, std::uint32_t* vertex) {
    std::uint64_t hash[largest_block];
    for (std::size_t i = 0; i < count; ++i) {
      hash[i] = hash_of(key_of(corner[i]));
      prefetch(&slot_[hash[i] >> shift_]);
    }
    for (std::size_t i = 0; i < count; ++i) vertex[i] = vertex_at(corner[i], hash[i]);
  }

 private:
  static constexpr std::size_t least_room = 64;

  struct Slot {
    std::uint32_t number;  ///< of the vertex, from 1; 0 where there is none
    std::uint32_t tag;     ///< the hash's lower half, so that few other vertices' places are looked at
  };

  /// A place by its bits, so that numbers that are none do no harm; -0 and 0 are the same place.
  struct Key {
    std::uint32_t x, y, z;
    bool operator==(const Key& other) const { return x == other.x && y == other.y && z == other.z; }
  };
  static Key key_of(const float* place) {
    const float raw[3] = {place[0] + 0.0f, place[1] + 0.0f, place[2] + 0.0f};
    Key key;
    std::memcpy(&key, raw, sizeof key);
    return key;
  }
  static Key key_of(const vcg::Point3f& place) { return key_of(place.V()); }

  /// Its upper bits depend on all bits of the key; these choose the slot.
  static std::uint64_t hash_of(const Key& key) {
    std::uint64_t hash = (static_cast<std::uint64_t>(key.x) << 32 | key.y) * 0x9e3779b97f4a7c15u;
    hash = ((hash ^ hash >> 32) + key.z) * 0xd6e8feb86659fd93u;
    return hash ^ hash >> 32;
  }

  static void prefetch(const void* address) {
#ifdef __GNUC__
    __builtin_prefetch(address);
#else
    (void)address;
#endif
  }

  std::uint32_t vertex_at(const vcg::Point3f& place, std::uint64_t hash) {
    const auto tag = static_cast<std::uint32_t>(hash);
    std::size_t at = hash >> shift_;
    for (; slot_[at].number != 0; at = (at + 1) & (slot_.size() - 1))
      if (slot_[at].tag == tag && key_of(place_of(slot_[at].number - 1)) == key_of(place)) return slot_[at].number - 1;
    const auto vertex = static_cast<std::uint32_t>(places_.size());
    slot_[at] = {vertex + 1, tag};
    places_.push_back(vcg::Point3d(place[0], place[1], place[2]));
    if (2 * places_.size() > slot_.size()) grow();
    return vertex;
  }

  const float* place_of(std::uint32_t vertex) const { return places_.floats() + 3 * static_cast<std::size_t>(vertex); }

  void make_room(std::size_t room) {
    slot_ = {};
    reserve_in_large_pages(slot_, room);
    slot_.resize(room);
    shift_ = 64;
    for (; room > 1; room /= 2) --shift_;
  }

  void grow() {
    make_room(2 * slot_.size());
    for (std::uint32_t vertex = 0; vertex < places_.size(); ++vertex) {
      const std::uint64_t hash = hash_of(key_of(place_of(vertex)));
      std::size_t at = hash >> shift_;
      while (slot_[at].number != 0) at = (at + 1) & (slot_.size() - 1);
      slot_[at] = {vertex + 1, static_cast<std::uint32_t>(hash)};
    }
  }

  Points& places_;
  std::vector<Slot> slot_;
  int shift_ = 0;  // what is left of a hash without it is an index into slot_
};

}  // namespace mesh_tools::io
