// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace vcg_core::detail {

/// A set of faces around a vertex is 32 bits, one for each face. A vertex of more faces is a hub: sets of its faces are
/// never made, and what changes around it is looked at face by face.
constexpr std::uint32_t most_face_bits = 32;

/// A face's bit among the faces of each of its two other vertices; 0 where that is a hub or not in the patch.
struct FaceMarks {
  std::uint32_t of_row_1;
  std::uint32_t of_row_2;
};

/// The shape of a face in |e| as seen from its apex v_i, as the virtual start point needs it (section 4.1). The frame
/// differs from TriangleFrame in that its origin is the middle of the edge: the paper's test "the intersect falls in
/// between" is then one comparison.
struct FaceShape {
  float half_edge;     ///< |v_{i+1} v_{i+2}| / 2; -1, with y 1, if there is no edge to cross
  float half_inverse;  ///< 1 / (2 |v_{i+1} v_{i+2}|)
  float squared_edge;
  float x;  ///< the apex
  float y;
  float side_1;  ///< |v_i v_{i+1}|
  float side_2;  ///< |v_i v_{i+2}|
  float edge;    ///< |v_{i+1} v_{i+2}|; makes it half a cache line
};

/// What a few groups of neighbouring sources need to know of the mesh: the vertices around them ("rows") and their
/// faces. The layout is plain so that the kernels, which are compiled for other processors than the rest, share no
/// inline code with it.
struct Patch {
  std::uint32_t rows;
  bool has_hubs;                    ///< whether a row has more faces than bits
  const float* place[3];            ///< by row: x, y, z relative to the patch's middle, in |e|
  const float* normal[3];           ///< by row: unit normal, zero if undefined
  const std::uint32_t* face_begin;  ///< rows + 1 offsets by face; a face's bit is its place behind the row's offset
  // By face as seen from a row, its apex v_i. If only one of the two other vertices lies in the patch, both rows are
  // that one's.
  const std::uint32_t* apex;   ///< row of v_i
  const std::uint32_t* row_1;  ///< row of v_{i+1}
  const std::uint32_t* row_2;  ///< row of v_{i+2}
  const FaceMarks* marks;

  FaceShape* shape;  ///< by face: what the kernel's `shape` leaves

  // Work memory of the kernel.
  float* distance;         ///< rows x lanes, aligned to 64 bytes: what the march leaves in the group's rows, in |e|
  std::uint32_t* pending;  ///< by row: bits of the faces to be looked at again, as a vertex of theirs improved
};

/// Whether a row has more faces than there are bits. Static, as every kernel is to have its own.
static inline bool is_hub(const Patch& patch, std::uint32_t row) {
  return patch.face_begin[row + 1] - patch.face_begin[row] > most_face_bits;
}

/// Buckets of the kernel's queue by distance.
constexpr std::uint32_t queue_buckets = 1024;

/// Work memory of that queue: a list of ranks for each bucket.
struct QueueMemory {
  std::uint32_t* first;      ///< by bucket
  std::uint32_t* bucket_of;  ///< by rank
  std::uint32_t* next;
  std::uint32_t* previous;
  std::uint32_t* improved;  ///< by rank: whether the row has improved and what is around it does not know yet
};

/// A group of sources on a patch, one a lane, and the rows within reach of one of them: by rising distance from the
/// group's middle, which is their rank.
struct PatchGroup {
  std::uint32_t sources;            ///< lanes in use
  const std::uint32_t* source_row;  ///< by lane
  std::uint32_t rows;               ///< how many rows of the patch are near
  std::uint32_t inner_rows;         ///< of the first ranks: as near to the middle as the sources themselves
  const std::uint32_t* row_at;      ///< by rank
  const std::uint32_t* rank_of;     ///< by row of the patch; not_near if it is not
  const float* squared_radius;      ///< by rank: squared distance from the middle, in |e|^2

  // Work memory of the kernel, for the ranks whose rows have pending faces.
  std::uint64_t* dirty;  ///< a bit a rank
  QueueMemory queue;
};

/// Rank of rows that are not near a group.
constexpr std::uint32_t not_near = 0xffffffff;

/// The filter's constants, in |e|.
struct LaneParameters {
  float cutoff;     ///< rho
  float limit;      ///< rho + margin: beyond it distances are not followed
  float tolerance;  ///< a smaller gain is not passed on; added to it: some units in the distance's last place
  /// After so many looks for each face around each row, and then again and again after a quarter of that, the tolerance
  /// is doubled: so the march ends in a time that follows from the size of the patch, whatever its shape.
  std::uint32_t looks_per_corner;
  /// Weight = exp2(-(squared distance * closeness + (height * similarity)^2 + ((1 - n_i.n_j) * normals)^2)).
  float closeness;
  float similarity;
  float normals;
};

/// Called now and then during long work; may throw.
using LanePoll = void (*)(void* context);

/// Keeps those of `count` rows, and of the values in `squared_radius` that belong to them, that lie within `reach`, in
/// |e|, of a source of the group. Returns how many.
using LaneNear = std::uint32_t (*)(const Patch& patch, const PatchGroup& group, float reach, std::uint32_t count,
                                   std::uint32_t* rows, float* squared_radius);

/// Computes the shapes of all faces of a patch.
using LaneShape = void (*)(const Patch& patch, LanePoll poll, void* context);

/// What a march has cost.
struct MarchWork {
  std::uint64_t
      looks;      ///< visits to rows and, in large neighbourhoods, to the faces around them; for all lanes at once
  bool loosened;  ///< whether the tolerance was raised, so that it ended: see LaneParameters::looks_per_corner
};

/// Marches from all sources of the group at once and leaves the distances in patch.distance.
using LaneMarch = MarchWork (*)(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters,
                                LanePoll poll, void* context);

/// Section 6's offset of each lane's source, in |e|, from the distances that the march left.
using LaneOffsets = void (*)(const Patch& patch, const PatchGroup& group, const LaneParameters& parameters,
                             float* offset);

/// A kernel compiled for one kind of processor.
struct LaneKernel {
  const char* name;
  std::uint32_t lanes;
  bool (*supported)();
  LaneNear within_reach;
  LaneShape shape;
  LaneMarch march;
  LaneOffsets offsets;
};

constexpr std::uint32_t most_lanes = 16;

}  // namespace vcg_core::detail
