#pragma once

#include "Model/Ids.h"

#include <memory>

namespace strata
{
/// An array of plain values whose memory can be handed on without a copy (made with new[]; not initialized).
template<typename T>
class Buffer
{
public:
  Buffer() = default;
  explicit Buffer(Index size) : data_(new T[static_cast<std::size_t>(size)]), size_(size) {}

  Index size() const { return size_; }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  T& operator[](Index i) { return data_[static_cast<std::size_t>(i)]; }
  const T& operator[](Index i) const { return data_[static_cast<std::size_t>(i)]; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  /// Gives the memory away; the caller frees it with delete[].
  T* release()
  {
    size_ = 0;
    return data_.release();
  }

private:
  std::unique_ptr<T[]> data_;
  Index size_ = 0;
};
}
