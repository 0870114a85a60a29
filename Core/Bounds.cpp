#include "Bounds.h"

#include "Model/Errors.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace strata
{
namespace
{
/// Values are stored as floats: no bound can be met below a few of their steps.
constexpr double resolution = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon());

/// Positive floats are ordered as their bit patterns are.
std::uint32_t bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float floatOf(std::uint32_t bits)
{
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}

void check(const SelectOptions& options, const std::vector<Field>& fields, const BuildOptions& build)
{
  const ErrorBounds& bounds = options.bounds;
  const Index rootCount = Index{ 6 } * build.baseCubes[0] * build.baseCubes[1] * build.baseCubes[2];
  if (options.maximumNumberOfCells < rootCount)
  {
    throw InvalidInput("the maximum number of cells is " + std::to_string(options.maximumNumberOfCells) +
                       "; the base mesh alone has " + std::to_string(rootCount));
  }
  if (!(bounds.interfaceError > 0.0))
  {
    throw InvalidInput(
      "the interface error bound is " + std::to_string(bounds.interfaceError) + "; it must be greater than zero");
  }
  if (bounds.fieldErrors.size() != fields.size())
  {
    throw InvalidInput("there are " + std::to_string(bounds.fieldErrors.size()) + " field error bounds for " +
                       std::to_string(fields.size()) + " fields");
  }
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    if (!(bounds.fieldErrors[f] > 0.0))
    {
      throw InvalidInput("the error bound of field '" + fields[f].name + "' is " +
                         std::to_string(bounds.fieldErrors[f]) + "; it must be greater than zero");
    }
  }
}

ErrorBounds finestOf(const SelectOptions& select)
{
  ErrorBounds finest = select.bounds;
  if (select.finestBounds.interfaceError > 0.0)
  {
    finest.interfaceError = std::min(finest.interfaceError, select.finestBounds.interfaceError);
  }
  for (std::size_t f = 0; f < select.finestBounds.fieldErrors.size(); ++f)
  {
    const double bound = select.finestBounds.fieldErrors[f];
    finest.fieldErrors[f] = bound > 0.0 ? std::min(finest.fieldErrors[f], bound) : finest.fieldErrors[f];
  }
  return finest;
}

double smallestScale(const std::function<bool(double)>& fits)
{
  std::uint32_t low = bitsOf(1.0f);
  std::uint32_t high = bitsOf(std::numeric_limits<float>::max());
  while (low < high)
  {
    const std::uint32_t middle = low + (high - low) / 2;
    const bool enough = fits(static_cast<double>(floatOf(middle)));
    high = enough ? middle : high;
    low = enough ? low : middle + 1;
  }
  return static_cast<double>(floatOf(high));
}

ErrorBounds scaled(ErrorBounds bounds, double scale)
{
  bounds.interfaceError *= scale;
  for (double& bound : bounds.fieldErrors)
  {
    bound *= scale;
  }
  return bounds;
}

ErrorBounds attainable(ErrorBounds bounds, const NativeData& native)
{
  bounds.interfaceError = std::max(bounds.interfaceError, resolution * native.box().diagonal());
  for (std::size_t f = 0; f < bounds.fieldErrors.size(); ++f)
  {
    const double smallest = resolution * native.magnitude(FieldId(static_cast<Index>(f)));
    bounds.fieldErrors[f] = std::max(bounds.fieldErrors[f], smallest);
  }
  return bounds;
}

bool meets(const Achieved& achieved, const ErrorBounds& bounds)
{
  bool result = achieved.interfaceError <= bounds.interfaceError;
  for (std::size_t f = 0; f < bounds.fieldErrors.size(); ++f)
  {
    result = result && achieved.fieldErrors[f] <= bounds.fieldErrors[f];
  }
  return result;
}

std::string reasonOf(const Achieved& achieved, const ErrorBounds& attainableBounds, bool everywhere)
{
  return everywhere && meets(achieved, attainableBounds) ? "resolution of the stored values" : "maximum level";
}
}
