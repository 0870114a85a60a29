#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace strata
{
/// How far a computation is, and whether the user wants it to stop.
///
/// One object serves a whole pipeline. `stage` and `update` belong to the thread that made the object;
/// `check` may be called from any thread, often: it costs an atomic read, and every 50 ms, on the
/// owner's thread, a call of the callback. It throws Cancelled once the callback has returned false.
class Progress
{
public:
  /// Receives the name of the stage and the fraction done, 0 to 1; returns false to stop.
  using Callback = std::function<bool(const std::string& stage, double fraction)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  /// Begins a named stage that covers the given part of the whole, [from, to] within [0, 1].
  void stage(const std::string& name, double from, double to);
  /// Reports the fraction of the stage that is done.
  void update(double fractionOfStage);
  /// Throws Cancelled if the user asked to stop.
  void check();

private:
  void report();

  Callback callback_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::string stage_;
  double from_ = 0.0;
  double to_ = 1.0;
  double fraction_ = 0.0;
  std::chrono::steady_clock::time_point last_;
  std::atomic<bool> cancelled_{ false };
};
}
