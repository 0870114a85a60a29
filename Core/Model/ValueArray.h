#pragma once

#include "Model/Ids.h"

#include <memory>

namespace strata
{
/// A read-only array of float or double tuples that somebody else may own. Null until given memory.
class ValueArray
{
public:
  ValueArray() = default;
  /// `keepAlive` holds the memory; it may be null where the caller outlives the array.
  ValueArray(const float* data, Index tuples, int components, std::shared_ptr<const void> keepAlive = {}) :
    floats_(data), tuples_(tuples), components_(components), keepAlive_(std::move(keepAlive))
  {}
  ValueArray(const double* data, Index tuples, int components, std::shared_ptr<const void> keepAlive = {}) :
    doubles_(data), tuples_(tuples), components_(components), keepAlive_(std::move(keepAlive))
  {}

  explicit operator bool() const { return floats_ || doubles_; }
  Index tuples() const { return tuples_; }
  int components() const { return components_; }
  double operator()(Index tuple, int component = 0) const
  {
    const Index i = tuple * components_ + component;
    return floats_ ? static_cast<double>(floats_[i]) : doubles_[i];
  }

private:
  const float* floats_ = nullptr;
  const double* doubles_ = nullptr;
  Index tuples_ = 0;
  int components_ = 1;
  std::shared_ptr<const void> keepAlive_;
};
}
