#include "Conversion/CheckFractions.h"

#include "Conversion/ValueConversion.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace strata::conversion
{
namespace
{
/// Deviations up to here are rounding and left as they are.
constexpr double roundingDeviation = 1e-6;

bool isHidden(const FractionPlaces& places, Index i)
{
  return places.association == Association::Cells && !places.hidden.empty() &&
         places.hidden[static_cast<std::size_t>(i)] != 0;
}

double sumAt(const std::vector<ValueArray>& fractions, Index i)
{
  double sum = 0.0;
  for (const ValueArray& fraction : fractions)
  {
    sum += fraction(i);
  }
  return sum;
}

std::string describe(const FractionPlaces& places, Index i)
{
  if (places.association == Association::Cells)
  {
    return describeCell(places.input, i);
  }
  const auto& source = places.input.pointSource;
  return "point " + std::to_string(source.empty() ? i : source[static_cast<std::size_t>(i)]);
}

/// The worst place's story: "the fraction 'vf_a' of cell 3 is 1.2" or "... of cell 3 sum to 1.31".
std::string describeDeviation(const std::vector<ValueArray>& fractions, const std::vector<std::string>& names,
  const FractionPlaces& places, Index i)
{
  std::ostringstream text;
  std::size_t worst = 0;
  const auto overshoot = [&](std::size_t m) {
    const double value = fractions[m](i);
    return std::isfinite(value) ? std::max(-value, value - 1.0) : 1e300;
  };
  for (std::size_t m = 1; m < fractions.size(); ++m)
  {
    worst = overshoot(m) > overshoot(worst) ? m : worst;
  }
  const double sum = sumAt(fractions, i);
  if (overshoot(worst) >= std::abs(sum - 1.0) || !std::isfinite(sum))
  {
    text << "the volume fraction of '" << names[worst] << "' in " << describe(places, i) << " is "
         << fractions[worst](i);
  }
  else
  {
    text << "the volume fractions of " << describe(places, i) << " sum to " << sum;
  }
  return text.str();
}

double deviationAt(const std::vector<ValueArray>& fractions, Index i)
{
  double sum = 0.0;
  double deviation = 0.0;
  for (const ValueArray& fraction : fractions)
  {
    const double value = fraction(i);
    sum += value;
    deviation = std::max({ deviation, -value, value - 1.0 });
  }
  return std::isfinite(sum) ? std::max(deviation, std::abs(sum - 1.0)) : std::numeric_limits<double>::infinity();
}

struct Deviations
{
  Index worst = 0;
  double largest = 0.0;
  Index warned = 0;
};

Deviations examine(const std::vector<ValueArray>& fractions, const FractionPlaces& places)
{
  Deviations result;
  for (Index i = 0; i < fractions.front().tuples(); ++i)
  {
    const double deviation = isHidden(places, i) ? 0.0 : deviationAt(fractions, i);
    result.warned += deviation > silentDeviation;
    if (deviation > result.largest)
    {
      result.largest = deviation;
      result.worst = i;
    }
  }
  return result;
}

void rescale(std::vector<ValueArray>& fractions)
{
  const Index count = fractions.front().tuples();
  std::vector<std::vector<float>> scaled(fractions.size(), std::vector<float>(static_cast<std::size_t>(count)));
  for (Index i = 0; i < count; ++i)
  {
    double sum = 0.0;
    for (const ValueArray& fraction : fractions)
    {
      sum += std::clamp(fraction(i), 0.0, 1.0);
    }
    for (std::size_t m = 0; m < fractions.size(); ++m)
    {
      const double value = std::clamp(fractions[m](i), 0.0, 1.0);
      scaled[m][static_cast<std::size_t>(i)] = static_cast<float>(sum > 0.0 ? value / sum : value);
    }
  }
  for (std::size_t m = 0; m < fractions.size(); ++m)
  {
    fractions[m] = ownedValues(std::move(scaled[m]));
  }
}
}

bool leaveSpace(const std::vector<ValueArray>& fractions, const FractionPlaces& places)
{
  for (Index i = 0; i < fractions.front().tuples(); ++i)
  {
    if (!isHidden(places, i) && sumAt(fractions, i) < largestDeviation)
    {
      return true;
    }
  }
  return false;
}

ValueArray remainderOf(const std::vector<ValueArray>& fractions)
{
  std::vector<float> remainder(static_cast<std::size_t>(fractions.front().tuples()));
  for (std::size_t i = 0; i < remainder.size(); ++i)
  {
    remainder[i] = static_cast<float>(std::clamp(1.0 - sumAt(fractions, static_cast<Index>(i)), 0.0, 1.0));
  }
  return ownedValues(std::move(remainder));
}

void normaliseFractions(std::vector<ValueArray>& fractions, const std::vector<std::string>& names,
  const FractionPlaces& places, Warnings& warnings)
{
  const Deviations found = examine(fractions, places);
  if (found.largest <= roundingDeviation)
  {
    return;
  }
  const std::string worst = describeDeviation(fractions, names, places, found.worst);
  if (found.largest > largestDeviation)
  {
    throw InvalidInput("Volume fractions must lie within [0, 1] and sum to 1, but " + worst);
  }
  if (found.warned > 0)
  {
    warnings.push_back("Volume fractions are scaled to sum to 1 in " + std::to_string(found.warned) +
                       (places.association == Association::Cells ? " cells" : " points") + "; the worst: " + worst);
  }
  rescale(fractions);
}
}
