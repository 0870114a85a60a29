#pragma once

#include <string>
#include <vector>

namespace impact
{
/// What the program can be asked for; each member is a command-line key of the same name.
struct Options
{
  int res = 2;                                             ///< cells per output cell of the 32 grid, in each direction
  std::vector<double> out = { 1, 2 };                      ///< output grids: divisors of `res`
  std::vector<double> times = { -0.5, 1.5, 4, 8, 15, 24 }; ///< microseconds after the first contact
  std::string dir = ".";                                   ///< where the files go
  std::string projectile = "tantalum";
  std::string block = "nickel";
  double radius = 1.5;   ///< of the projectile, cm
  double speed = 0.5;    ///< of the projectile along -z, cm per microsecond
  double side = 10.2;    ///< the block is [0, side]^2 x [bottom, 0], cm
  double bottom = -14.2; ///< cm
  double strength = 1;   ///< multiplies both yield strengths
  double cfl = 0.45;     ///< time step over the time that the fastest wave needs to cross a cell
};

/// Reads `--key value ...`; throws std::invalid_argument that names a bad key or value.
Options parseOptions(int argumentCount, char** arguments);
}
