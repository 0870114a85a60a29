/// Simulates the hypervelocity impact of a metal sphere on a metal block; README.md says how and why.
#include "Simulation.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace impact
{
namespace
{
/// Steps in the six orders of the axes in turn, so that none of them is preferred.
constexpr int axisOrder[6][3] = { { 0, 1, 2 }, { 2, 1, 0 }, { 1, 0, 2 }, { 2, 0, 1 }, { 0, 2, 1 }, { 1, 2, 0 } };

void run(const Options& options)
{
  Simulation simulation(options);
  const double gap = 0.5; // cm between sphere and block at the start
  const double width = simulation.spacing[0];
  setInitialState(simulation, gap);
  double time = -gap / options.speed;
  double rate = 0.5 / width + 2 * options.speed / width;
  std::size_t next = 0;
  for (int step = 0; next < options.times.size(); ++step)
  {
    double timeStep = options.cfl / rate;
    const bool save = time + timeStep >= options.times[next] - 1e-9;
    if (save)
    {
      timeStep = std::max(1e-6, options.times[next] - time);
    }
    if (step % 20 == 0)
    {
      report(simulation, step, time, timeStep);
    }
    rate = (0.3 + options.speed) / width;
    for (const int axis : axisOrder[step % 6])
    {
      rate = std::max(rate, sweep(simulation, axis, timeStep));
    }
    time += timeStep;
    if (save)
    {
      report(simulation, step + 1, time, timeStep);
      for (const double factor : options.out)
      {
        writeGrid(simulation, int(factor), int(next), time);
      }
      ++next;
    }
  }
}
}
}

int main(int argumentCount, char** arguments)
{
  try
  {
    impact::run(impact::parseOptions(argumentCount, arguments));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "impact_generator: %s\n", error.what());
    return 1;
  }
  return 0;
}
