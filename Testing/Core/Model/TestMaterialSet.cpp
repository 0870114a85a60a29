#include "Model/Materials.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

namespace strata
{
namespace
{
TEST(MaterialSet, BehavesAsASetOfSmallNumbers)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> id(0, MaterialSet::capacity - 1);
  for (int trial = 0; trial < 200; ++trial)
  {
    MaterialSet set;
    std::set<int> expected;
    for (int i = 0; i < trial % 20; ++i)
    {
      const int m = id(random);
      set.insert(MaterialId(m));
      expected.insert(m);
    }
    if (!expected.empty() && trial % 3 == 0)
    {
      set.erase(MaterialId(*expected.begin()));
      expected.erase(expected.begin());
    }
    std::vector<int> members;
    for (const MaterialId m : set)
    {
      EXPECT_TRUE(set.contains(m));
      EXPECT_EQ(static_cast<int>(members.size()), set.rank(m));
      members.push_back(m.value);
    }
    EXPECT_EQ(std::vector<int>(expected.begin(), expected.end()), members);
    EXPECT_EQ(static_cast<int>(expected.size()), set.size());
  }
}

TEST(MaterialSet, UnionIntersectionAndDifferenceAreThoseOfSets)
{
  const MaterialSet a = MaterialSet::of(MaterialId(0)) | MaterialSet::of(MaterialId(63));
  const MaterialSet b = MaterialSet::of(MaterialId(63)) | MaterialSet::of(MaterialId(5));
  EXPECT_EQ(MaterialSet::of(MaterialId(63)), a & b);
  EXPECT_EQ(MaterialSet::of(MaterialId(0)), a - b);
  EXPECT_EQ(3, (a | b).size());
  EXPECT_TRUE((a | b).includes(a));
  EXPECT_FALSE(a.includes(b));
}
}
}
