#pragma once

#include <cstddef>
#include <cstdint>

namespace strata::test
{
/// Turns a fuzzer's bytes into decisions; zeros once they are used up.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  int below(int end) { return end > 0 ? static_cast<int>(next() * 256u + next()) % end : 0; }
  bool chance(int oneIn) { return below(oneIn) == oneIn - 1; }
  /// Within [0, 1), in steps of 1/65536.
  double unit() { return (next() * 256u + next()) / 65536.0; }

private:
  std::uint32_t next() { return at_ < size_ ? data_[at_++] : 0u; }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};
}
