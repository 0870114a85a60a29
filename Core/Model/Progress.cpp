#include "Model/Progress.h"

#include "Model/Errors.h"

namespace strata
{
namespace
{
constexpr std::chrono::milliseconds reportInterval{ 50 };
}

void Progress::stage(const std::string& name, double from, double to)
{
  stage_ = name;
  from_ = from;
  to_ = to;
  fraction_ = from;
  report();
}

void Progress::update(double fractionOfStage)
{
  fraction_ = from_ + (to_ - from_) * fractionOfStage;
  check();
}

void Progress::check()
{
  if (callback_ && std::this_thread::get_id() == owner_ && std::chrono::steady_clock::now() - last_ > reportInterval)
  {
    report();
  }
  if (cancelled_)
  {
    throw Cancelled();
  }
}

void Progress::report()
{
  last_ = std::chrono::steady_clock::now();
  if (callback_ && !callback_(stage_, fraction_))
  {
    cancelled_ = true;
    throw Cancelled();
  }
}
}
