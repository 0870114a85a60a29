#include "Model/Errors.h"
#include "Model/Progress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace strata
{
namespace
{
TEST(Progress, AStageCoversItsPartOfTheWhole)
{
  std::vector<std::pair<std::string, double>> reports;
  Progress progress([&](const std::string& stage, double fraction) {
    reports.emplace_back(stage, fraction);
    return true;
  });
  progress.stage("first", 0.0, 0.5);
  progress.stage("second", 0.5, 1.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  progress.update(0.5);
  ASSERT_EQ(3u, reports.size());
  EXPECT_EQ((std::pair<std::string, double>("first", 0.0)), reports[0]);
  EXPECT_EQ((std::pair<std::string, double>("second", 0.5)), reports[1]);
  EXPECT_EQ((std::pair<std::string, double>("second", 0.75)), reports[2]);
}

TEST(Progress, EveryThreadLearnsThatTheUserWantsToStop)
{
  Progress progress([](const std::string&, double) { return false; });
  EXPECT_THROW(progress.stage("any", 0.0, 1.0), Cancelled);
  bool stopped = false;
  std::thread other([&] {
    try
    {
      progress.check();
    }
    catch (const Cancelled&)
    {
      stopped = true;
    }
  });
  other.join();
  EXPECT_TRUE(stopped);
}

TEST(Progress, WithoutACallbackNothingStops)
{
  Progress progress;
  progress.stage("any", 0.0, 1.0);
  EXPECT_NO_THROW(progress.update(1.0));
}
}
}
