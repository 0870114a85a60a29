#include "Material.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace impact
{
const Material& findMaterial(const std::string& name)
{
  // Textbook-like values, fitted to nothing. Columns as in Material.
  static const std::vector<Material> materials = {
    { "steel", 7.85, 0.4569, 1.490, 2.17, 0.77, 0.012, 0.0085, 0.030 },
    { "nickel", 8.90, 0.4602, 1.437, 1.93, 0.80, 0.012, 0.0075, 0.030 },
    { "tantalum", 16.65, 0.3414, 1.200, 1.67, 0.69, 0.011, 0.0055, 0.040 },
    { "tungsten", 19.24, 0.4030, 1.237, 1.54, 1.60, 0.020, 0.0060, 0.030 },
    { "copper", 8.93, 0.3940, 1.489, 1.99, 0.477, 0.0045, 0.0047, 0.020 },
    { "aluminium", 2.703, 0.5240, 1.400, 1.97, 0.276, 0.0045, 0.0065, 0.012 },
  };
  for (const Material& material : materials)
  {
    if (material.name == name)
    {
      return material;
    }
  }
  throw std::invalid_argument("unknown metal " + name);
}

Pressure equationOfState(const Material& material, double density, double energy)
{
  const double restDensity = material.density;
  const double gamma = material.gamma;
  const double speed = material.soundSpeed;
  const double restModulus = restDensity * speed * speed;
  const double compression = 1 - restDensity / density;
  double pressure;
  double derivative; // of the pressure by density, along an adiabat
  if (compression >= 0)
  {
    const double slope = material.hugoniotSlope;
    const double x = std::min(compression, 0.75 / slope); // the Hugoniot's pole lies at 1 / slope
    const double q = 1 - slope * x;
    const double hugoniot = restModulus * x / (q * q);
    const double g = 1 - 0.5 * gamma * x;
    const double rise = restModulus * (1 + slope * x) / (q * q * q) * g - 0.5 * gamma * hugoniot;
    pressure = hugoniot * g + rise * (compression - x) + gamma * restDensity * energy;
    derivative = rise * restDensity / (density * density) + pressure * gamma * restDensity / (density * density);
  }
  else
  {
    pressure = speed * speed * (density - restDensity) + gamma * density * energy;
    derivative = speed * speed + gamma * energy + pressure * gamma / density;
  }
  return { pressure, std::max(density * derivative, 0.1 * restModulus) };
}

double softening(const Material& material, double density, double energy)
{
  const double compression = std::max(0.0, 1 - material.density / density);
  const double cold = 0.5 * material.soundSpeed * material.soundSpeed * compression * compression;
  return std::clamp(1 - (energy - cold) / material.meltingEnergy, 0.0, 1.0);
}
}
