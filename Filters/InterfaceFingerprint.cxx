#include "InterfaceFingerprint.h"

#include <cstring>

namespace
{
/// Two inputs with the same number are the same, but for a chance of 2^-64 or so.
class Fingerprint
{
public:
  void add(std::uint64_t bits)
  {
    // A step of SplitMix64 over the running value.
    value_ = (value_ ^ bits) + 0x9e3779b97f4a7c15u;
    value_ = (value_ ^ (value_ >> 30)) * 0xbf58476d1ce4e5b9u;
    value_ = (value_ ^ (value_ >> 27)) * 0x94d049bb133111ebu;
    value_ ^= value_ >> 31;
  }
  void add(double value)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  template<typename T>
  void addAll(const std::vector<T>& values)
  {
    add(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values)
    {
      add(static_cast<std::uint64_t>(value));
    }
  }
  void addAll(const std::vector<double>& values)
  {
    add(static_cast<std::uint64_t>(values.size()));
    for (const double value : values)
    {
      add(value);
    }
  }
  void addAll(const strata::ValueArray& values)
  {
    add(static_cast<std::uint64_t>(values.tuples()));
    for (strata::Index i = 0; i < values.tuples(); ++i)
    {
      add(values(i));
    }
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0;
};

void addGrid(const strata::RectilinearGrid& grid, Fingerprint& print)
{
  for (const std::vector<double>& axis : grid.coordinates)
  {
    print.addAll(axis);
  }
  print.addAll(grid.hidden);
}

void addGrid(const strata::UnstructuredGrid& grid, Fingerprint& print)
{
  for (const strata::Vector& point : grid.points)
  {
    print.add(point[0]);
    print.add(point[1]);
    print.add(point[2]);
  }
  print.addAll(grid.shapes);
  print.addAll(grid.cornerOffsets);
  print.addAll(grid.corners);
  print.addAll(grid.faceOffsets);
  print.addAll(grid.faceStart);
  print.addAll(grid.faceCorners);
  print.addAll(grid.hidden);
}
}

std::uint64_t fingerprintOf(const strata::Simulation& simulation, const strata::ExtractOptions& options)
{
  Fingerprint print;
  std::visit([&](const auto& grid) { addGrid(grid, print); }, simulation.grid);
  print.add(static_cast<std::uint64_t>(simulation.materials.size()));
  print.add(static_cast<std::uint64_t>(simulation.fractionAssociation));
  for (const strata::ValueArray& fractions : simulation.fractions)
  {
    print.addAll(fractions);
  }
  print.addAll(simulation.materialIds);
  print.add(static_cast<std::uint64_t>(options.volumeCorrection));
  print.add(static_cast<std::uint64_t>(options.gatherSmearedFractions));
  print.add(options.minimumVolumeFraction);
  return print.value();
}
