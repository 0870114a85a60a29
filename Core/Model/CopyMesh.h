#pragma once

#include "Model/Mesh.h"

#include <cstddef>

namespace strata
{
/// The memory of a mesh's buffers.
std::size_t bytesOf(const Mesh& mesh);

/// A mesh with buffers of its own; buffers are copied here alone, since none should be by mistake.
Mesh copyOf(const Mesh& mesh);
}
