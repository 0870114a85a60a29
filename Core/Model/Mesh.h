#pragma once

#include "Model/Buffer.h"
#include "Model/Materials.h"
#include "Model/NativeData.h"

#include <optional>
#include <string>
#include <vector>

namespace strata
{
/// What a level of the hierarchy achieved (design 2): errors in the data's units, never the requested ones.
struct Achieved
{
  double interfaceError = 0.0;
  /// Where distances are certified: that between the original and the represented boundary of any one material's
  /// region, both ways, whichever materials it touches there.
  std::optional<double> regionError;
  std::vector<double> fieldErrors; ///< one per field
  bool boundMet = true;
  /// "bounds met", "maximum level", "maximum number of cells", "resolution of the stored values".
  std::string stoppedBy;
};

/// The representation (design 1): tetrahedra, and at their vertices a distance and field values per material.
struct Mesh
{
  Materials materials;
  std::vector<Field> fields;

  Buffer<double> points;           ///< 3 per vertex
  Buffer<std::int64_t> tetrahedra; ///< 4 vertices per cell, positively oriented

  // One buffer per material (and field); empty where not asked for or where the material has no fields.
  std::vector<Buffer<float>> distances;           ///< NaN where no cell round the vertex holds the material
  std::vector<Buffer<std::uint8_t>> ghosts;       ///< 0 inside, 1 ghost value, 2 not needed
  std::vector<std::vector<Buffer<float>>> values; ///< [field][material], components interleaved
  Buffer<std::int32_t> vertexMaterial;            ///< material that the vertex lies in
  std::vector<Buffer<float>> composite;           ///< [field], that material's value

  Buffer<std::int32_t> cellMaterial; ///< its index if one material fills the cell, else -1
  Buffer<std::int32_t> cellLevel;    ///< number of bisections
  Buffer<float> cellInterfaceError;
  std::vector<Buffer<float>> cellFieldErrors; ///< one per field

  Achieved achieved;

  Index vertexCount() const { return points.size() / 3; }
  Index cellCount() const { return tetrahedra.size() / 4; }
};
}
