#pragma once

#include "Build/BuildOptions.h"
#include "Model/Interfaces.h"
#include "Model/Mesh.h"
#include "Model/Progress.h"
#include "Select/SelectOptions.h"

#include <memory>

namespace strata
{
/// A hierarchy and what it was built from: moved from level to level without reading the input again.
class Multiresolution
{
public:
  /// Starts a hierarchy. `native` and `interfaces` are kept.
  Multiresolution(
    std::shared_ptr<const NativeData> native, Interfaces interfaces, const BuildOptions& options, Progress& progress);
  ~Multiresolution();
  Multiresolution(Multiresolution&&) noexcept;
  Multiresolution& operator=(Multiresolution&&) noexcept;

  /// Extends the hierarchy where it must, selects the level and emits it.
  Mesh level(const SelectOptions& options, Progress& progress);

private:
  struct State;
  std::unique_ptr<State> state_;
};
}
