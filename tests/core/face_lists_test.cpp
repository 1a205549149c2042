// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of faces come back as they were written, whatever faces they refer to.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include <mesh_tools/random.h>

#include "filters/guided/face_lists.h"

namespace {

using namespace vcg_core::detail;

class Lists : public testing::TestWithParam<std::size_t> {
 protected:
  /// Each begins with its own face; some are as long as may be, some refer to faces all over the mesh.
  Lists() {
    mesh_tools::Random random(GetParam());
    const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random.uniform() * double(below)); };
    for (std::size_t f = 0; f < GetParam(); ++f) {
      Array<Index> one{static_cast<Index>(f)};
      const std::size_t length = f % 50 == 7 ? FaceLists::longest : 1 + any(20);
      while (one.size() < length)
        one.push_back(static_cast<Index>(f % 3 == 0 ? any(GetParam()) : (f + any(9)) % GetParam()));
      list.push_back(one);
    }
    FaceLists::Writer writer(lists);
    for (std::size_t b = lists.blocks(); b-- > 0;)  // in any order
      writer.write(b, [&](Index f) -> const Array<Index>& { return list[f]; });
    lists.number_entries();
  }

  std::vector<Array<Index>> list;
  FaceLists lists{GetParam()};
};

TEST_P(Lists, ComeBackAsTheyWere) {
  std::size_t entries = 0, face = 0;
  for (std::size_t b = 0; b < lists.blocks(); ++b) {
    const FaceLists::Block& block = lists.block(b);
    EXPECT_EQ(block.first, face);
    EXPECT_EQ(block.first_entry, entries);
    for_each_list(block, [&](std::size_t i, std::size_t first, std::size_t length) {
      ASSERT_EQ(length, list[block.first + i].size());
      for (std::size_t k = 0; k < length; ++k) EXPECT_EQ(block.face(block.entry[first + k]), list[block.first + i][k]);
    });
    face += block.length.size();
    entries += block.entry.size();
  }
  EXPECT_EQ(face, GetParam());
  EXPECT_EQ(lists.entries(), entries);
}

TEST_P(Lists, GatherValuesByEntry) {
  std::vector<Index> value;
  for (std::size_t b = 0; b < lists.blocks(); ++b) {
    const FaceLists::Block& block = lists.block(b);
    gather(block, value, [](std::size_t f) { return static_cast<Index>(3 * f); });
    for (const std::uint16_t entry : block.entry) EXPECT_EQ(value[entry], 3 * block.face(entry));
    EXPECT_TRUE(std::all_of(block.far.begin(), block.far.end(),
                            [&](Index f) { return f - block.first >= block.length.size(); }));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Lists, testing::Values(0, 1, 255, 256, 257, 3000));

}  // namespace
