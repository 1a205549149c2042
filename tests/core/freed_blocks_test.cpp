// SPDX-License-Identifier: GPL-3.0-or-later
#include "freed_blocks.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace {

using vcg_core::detail::FreedBlocks;

constexpr std::size_t room = 4096;

/// A system's memory, of which nothing is ever touched: who has each of its bytes.
struct System {
  enum class Owner : unsigned char { nobody, mapped };
  static std::vector<char> memory;
  static std::vector<Owner> owner;
  static std::size_t end, mapped, most_mapped;

  static void reset() {
    memory.assign(room * 64, 0);
    owner.assign(memory.size(), Owner::nobody);
    end = mapped = most_mapped = 0;
  }

  static void* map(std::size_t bytes) {
    char* const begin = memory.data() + end;
    std::fill_n(owner.begin() + static_cast<std::ptrdiff_t>(end), bytes, Owner::mapped);
    end += bytes;
    mapped += bytes;
    most_mapped = std::max(most_mapped, mapped);
    return begin;
  }

  static void unmap(void* begin, std::size_t bytes) {
    const std::ptrdiff_t at = static_cast<char*>(begin) - memory.data();
    for (std::size_t i = 0; i < bytes; ++i) {
      Owner& one = owner[static_cast<std::size_t>(at) + i];
      EXPECT_EQ(one, Owner::mapped) << "unmapped twice";
      one = Owner::nobody;
    }
    mapped -= bytes;
  }
};
std::vector<char> System::memory;
std::vector<System::Owner> System::owner;
std::size_t System::end, System::mapped, System::most_mapped;

class FreedBlocksTest : public testing::Test {
 protected:
  void SetUp() override { System::reset(); }

  void* allocate(std::size_t bytes) {
    void* const block = blocks.take(bytes);
    return block != nullptr ? block : System::map(bytes);
  }

  FreedBlocks blocks{System::unmap};
};

TEST_F(FreedBlocksTest, GoStraightBackToTheSystemWhereNobodyHasBegun) {
  blocks.give(allocate(64), 64);
  EXPECT_EQ(System::mapped, 0u);
  EXPECT_FALSE(blocks.release());
}

TEST_F(FreedBlocksTest, ServeTheNextArraysOfTheSameAndOfLesserSize) {
  blocks.begin();
  char* const first = static_cast<char*>(allocate(64));
  blocks.give(first, 64);
  EXPECT_EQ(System::mapped, 64u);
  char* const a = static_cast<char*>(allocate(24));
  char* const b = static_cast<char*>(allocate(40));
  EXPECT_GE(std::min(a, b), first);
  EXPECT_LE(std::max(a + 24, b + 40), first + 64);
  EXPECT_EQ(System::mapped, 64u);
  blocks.give(b, 40);
  blocks.give(a, 24);
  EXPECT_EQ(allocate(64), first) << "parts that adjoin are one block again";
  blocks.give(first, 64);
  blocks.end();
  EXPECT_EQ(System::mapped, 0u);
}

TEST_F(FreedBlocksTest, LeaveOthersRoomWhereNoneFits) {
  blocks.begin();
  void* const small = allocate(40);
  blocks.give(small, 40);
  void* const large = allocate(100);
  EXPECT_EQ(System::mapped, 100u);
  EXPECT_EQ(System::most_mapped, 100u);
  blocks.give(large, 100);
  blocks.end();
}

TEST_F(FreedBlocksTest, WaitUntilTheLastHasEnded) {
  blocks.begin();
  blocks.begin();
  blocks.give(allocate(8), 8);
  blocks.end();
  EXPECT_EQ(System::mapped, 8u);
  blocks.end();
  EXPECT_EQ(System::mapped, 0u);
}

TEST_F(FreedBlocksTest, AreReleasedForWhoWasRefused) {
  blocks.begin();
  blocks.give(allocate(32), 32);
  EXPECT_EQ(blocks.take(64), nullptr);  // and the system refuses it
  EXPECT_FALSE(blocks.release()) << "what would not fit beside it has gone already";
  blocks.give_up(64);
  blocks.give(allocate(48), 48);
  EXPECT_TRUE(blocks.release());
  EXPECT_EQ(System::mapped, 0u);
  blocks.end();
}

// Arrays come and go at random: no byte belongs to two, the peak is that without waiting blocks, and nothing stays.
TEST_F(FreedBlocksTest, TakeNoMoreThanTheArraysAtTheirPeak) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    System::reset();
    std::minstd_rand random(seed);
    std::map<char*, std::size_t> used;
    std::size_t in_use = 0, most_in_use = 0;
    blocks.begin();
    for (int step = 0; step < 300; ++step) {
      if (used.empty() || random() % 5 < 3) {
        const std::size_t bytes = 1 + random() % 400;
        if (in_use + bytes > room) continue;
        in_use += bytes;
        most_in_use = std::max(most_in_use, in_use);
        char* const block = static_cast<char*>(allocate(bytes));
        const auto next = used.lower_bound(block);
        if (next != used.end()) {
          EXPECT_LE(block + bytes, next->first);
        }
        if (next != used.begin()) {
          EXPECT_LE(std::prev(next)->first + std::prev(next)->second, block);
        }
        used.emplace(block, bytes);
      } else {
        auto one = used.begin();
        std::advance(one, static_cast<std::ptrdiff_t>(random() % used.size()));
        in_use -= one->second;
        blocks.give(one->first, one->second);
        used.erase(one);
      }
      EXPECT_LE(System::mapped, most_in_use);
    }
    EXPECT_EQ(System::most_mapped, most_in_use);
    for (const auto& [block, bytes] : used) blocks.give(block, bytes);
    blocks.end();
    EXPECT_EQ(System::mapped, 0u);
  }
}

}  // namespace
