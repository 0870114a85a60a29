#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace strata
{
/// Input that can't be used. The message names the thing and its value.
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The user asked to stop.
class Cancelled : public std::runtime_error
{
public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// A warning for the user: the input was usable, but not as it should be.
using Warnings = std::vector<std::string>;
}
