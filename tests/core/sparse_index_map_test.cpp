// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse_index_map.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace {

using vcg_core::detail::Index;
using vcg_core::detail::SparseIndexMap;

TEST(SparseIndexMap, HoldsWhatWasSetSinceItWasCleared) {
  std::mt19937 random(1);
  SparseIndexMap map(10000);
  for (int round = 0; round < 20; ++round) {
    std::map<Index, std::uint32_t> expected;
    for (int k = 0; k < 300; ++k) {
      const Index i = random() % 10000;
      const std::uint32_t number = random() % 1000;
      const auto before = expected.find(i);
      ASSERT_EQ(map.exchange(i, number), before == expected.end() ? SparseIndexMap::none : before->second);
      expected[i] = number;
    }
    for (Index i = 0; i < 10000; ++i)
      ASSERT_EQ(map[i], expected.count(i) > 0 ? expected[i] : SparseIndexMap::none) << i;
    map.clear();
  }
}

TEST(SparseIndexMap, HoldsItsLastIndex) {
  for (const std::size_t size : {1, 255, 256, 257, 512}) {
    SparseIndexMap map(size);
    EXPECT_EQ(map[static_cast<Index>(size - 1)], SparseIndexMap::none);
    map.set(static_cast<Index>(size - 1), 7);
    EXPECT_EQ(map[static_cast<Index>(size - 1)], 7u);
  }
}

}  // namespace
