#pragma once

#include "Emit/Emit.h"
#include "Model/Mesh.h"
#include "Model/Progress.h"
#include "PreparedInterfaces.h"
#include "Select/SelectOptions.h"

#include <memory>

namespace strata
{
/// A hierarchy and what it was built from: moved from level to level without reading the input again.
class Multiresolution
{
public:
  /// `native` and `interfaces` are kept; nothing is computed before the first level is asked for.
  Multiresolution(std::shared_ptr<const NativeData> native, Interfaces interfaces, const BuildOptions& options);
  /// The same, with interfaces that objects for other fields on the same grid may use too, one at a time.
  Multiresolution(std::shared_ptr<const NativeData> native, std::shared_ptr<PreparedInterfaces> interfaces,
    const BuildOptions& options);
  ~Multiresolution();
  Multiresolution(Multiresolution&&) noexcept;
  Multiresolution& operator=(Multiresolution&&) noexcept;

  /// Extends the hierarchy where it must, selects the level and emits it. The result depends on the options
  /// alone, not on the levels asked for before. Throws InvalidInput for bounds that are not positive.
  Mesh level(const SelectOptions& options, Progress& progress, const EmitOptions& emitted = {});

  /// The hierarchy as far as it has been built; null before the first level.
  const Hierarchy* hierarchy() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};
}
