#pragma once

#include "Emit/Emit.h"
#include "Model/ErrorBounds.h"
#include "Model/Mesh.h"

#include <list>

namespace strata
{
/// The meshes of levels that took long to find, for a slider that comes back to them: those asked for last, as many as
/// fit into a limit of memory.
class KeptLevels
{
public:
  /// What may differ between levels of one hierarchy.
  struct Key
  {
    ErrorBounds bounds;
    EmitOptions emitted;
  };

  explicit KeptLevels(std::size_t mostBytes) : mostBytes_(mostBytes) {}

  /// Null if it is not kept. Valid until the next call.
  const Mesh* find(const Key& key);
  /// Keeps a copy of a mesh that is not kept yet, and forgets those that were longest not asked for; keeps nothing that
  /// is larger than the limit.
  void keep(const Key& key, const Mesh& mesh);

private:
  struct Kept
  {
    Key key;
    Mesh mesh;
  };

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::list<Kept> levels_; ///< the one asked for last comes first
};
}
