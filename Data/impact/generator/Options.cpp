#include "Options.h"

#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace impact
{
namespace
{
std::vector<double> numbers(const std::string& text)
{
  std::vector<double> result;
  std::istringstream in(text);
  for (std::string number; std::getline(in, number, ',');)
  {
    result.push_back(std::stod(number));
  }
  return result;
}

void check(const Options& options)
{
  for (const double factor : options.out)
  {
    if (options.res < 1 || factor < 1 || options.res % static_cast<int>(factor))
    {
      throw std::invalid_argument("--out factors must divide --res");
    }
  }
}
}

Options parseOptions(int argumentCount, char** arguments)
{
  Options options;
  using Value = const std::string&;
  const std::map<std::string, std::function<void(Value)>> keys = {
    { "--res", [&](Value v) { options.res = std::stoi(v); } },
    { "--out", [&](Value v) { options.out = numbers(v); } },
    { "--times", [&](Value v) { options.times = numbers(v); } },
    { "--dir", [&](Value v) { options.dir = v; } },
    { "--projectile", [&](Value v) { options.projectile = v; } },
    { "--block", [&](Value v) { options.block = v; } },
    { "--radius", [&](Value v) { options.radius = std::stod(v); } },
    { "--speed", [&](Value v) { options.speed = std::stod(v); } },
    { "--side", [&](Value v) { options.side = std::stod(v); } },
    { "--bottom", [&](Value v) { options.bottom = std::stod(v); } },
    { "--strength", [&](Value v) { options.strength = std::stod(v); } },
    { "--cfl", [&](Value v) { options.cfl = std::stod(v); } },
  };
  for (int i = 1; i < argumentCount; i += 2)
  {
    const auto key = keys.find(arguments[i]);
    if (key == keys.end() || i + 1 == argumentCount)
    {
      throw std::invalid_argument(std::string("unknown or incomplete option ") + arguments[i]);
    }
    key->second(arguments[i + 1]);
  }
  check(options);
  return options;
}
}
