#include "KeptLevels.h"

#include "Model/CopyMesh.h"

#include <algorithm>
#include <tuple>

namespace strata
{
namespace
{
bool same(const KeptLevels::Key& a, const KeptLevels::Key& b)
{
  const auto parts = [](const KeptLevels::Key& key) {
    return std::tie(key.bounds.interfaceError, key.bounds.fieldErrors, key.emitted.distances,
      key.emitted.perMaterialValues, key.emitted.ghosts);
  };
  return parts(a) == parts(b);
}
}

const Mesh* KeptLevels::find(const Key& key)
{
  const auto at = std::find_if(levels_.begin(), levels_.end(), [&](const Kept& level) { return same(level.key, key); });
  if (at == levels_.end())
  {
    return nullptr;
  }
  levels_.splice(levels_.begin(), levels_, at);
  return &levels_.front().mesh;
}

void KeptLevels::keep(const Key& key, const Mesh& mesh)
{
  const std::size_t more = bytesOf(mesh);
  if (more > mostBytes_)
  {
    return;
  }
  while (bytes_ + more > mostBytes_)
  {
    bytes_ -= bytesOf(levels_.back().mesh);
    levels_.pop_back();
  }
  levels_.push_front({ key, copyOf(mesh) });
  bytes_ += more;
}
}
