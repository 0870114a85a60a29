#pragma once

#include <array>
#include <string>

namespace impact
{
/// A metal: Mie-Grueneisen equation of state about a linear Us-up Hugoniot, elastic-perfectly plastic.
struct Material
{
  std::string name;
  double density;       ///< at rest, g/cm^3
  double soundSpeed;    ///< c0 of Us = c0 + s up, cm per microsecond
  double hugoniotSlope; ///< s
  double gamma;         ///< Grueneisen's
  double shearModulus;  ///< Mbar
  double yieldStrength; ///< Mbar
  double meltingEnergy; ///< Mbar cm^3/g
  double spallStrength; ///< tension that opens a void, Mbar
};

/// The projectile's metal (0) and the block's (1).
struct Metals
{
  std::array<Material, 2> material;
  double strength = 1; ///< multiplies both yield strengths
};

/// A metal by its name; throws std::invalid_argument.
const Material& findMaterial(const std::string& name);

struct Pressure
{
  double value;       ///< Mbar
  double bulkModulus; ///< adiabatic, rho c^2, Mbar
};

/// The equation of state, from density (g/cm^3) and specific energy (Mbar cm^3/g).
Pressure equationOfState(const Material& material, double density, double energy);

/// What heat has left of a metal's strength: 1 cold to 0 molten.
double softening(const Material& material, double density, double energy);
}
