#pragma once

#include "Model/Materials.h"

#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkPolyData;

namespace strata::conversion
{
/// Names of the field data arrays with which a case or a representation describes itself.
namespace names
{
constexpr const char* materials = "material_names";
constexpr const char* hasFields = "material_has_fields";
constexpr const char* fields = "field_names";
/// One string per material: its array of volume fractions, "" where the others' remainder is meant.
constexpr const char* caseFractions = "strata_fraction_arrays";
/// Three strings per entry: field, material ("" for all), array.
constexpr const char* caseFields = "strata_field_arrays";
constexpr const char* positive = "positive_material";
constexpr const char* negative = "negative_material";
/// Cell arrays: the number of a surface's pair of materials, and a cell's material.
constexpr const char* pair = "pair";
constexpr const char* material = "material";
/// The block of a case that holds the grid.
constexpr const char* grid = "grid";
}

/// A field's values for one material, or for all that have no array of their own.
struct CaseField
{
  std::string field;
  std::string material; ///< "" for all
  std::string array;
};

/// What a case file says about its grid.
struct CaseDescription
{
  Materials materials;
  std::vector<std::string> fractionArrays; ///< one per material
  std::vector<CaseField> fields;
};

/// Writes a description to the field data of a grid, and reads it back; no materials if there is none.
void describeCase(const CaseDescription& description, vtkFieldData* data);
CaseDescription caseDescription(vtkFieldData* data);

/// Materials as they stand in field data (`material_names`, `material_has_fields`), and back.
void writeMaterials(const Materials& materials, vtkFieldData* data);
Materials readMaterials(vtkFieldData* data);

struct NamedSurface
{
  std::string name; ///< `<positive>|<negative>`, or whatever the block is called
  vtkSmartPointer<vtkPolyData> surface;
};

/// An input that is a case (a collection with a block named `grid`, the others being surfaces), or a grid alone.
struct CaseData
{
  vtkSmartPointer<vtkDataObject> grid;
  bool hasSurfaces = false; ///< true for a case, even if it has no surface
  std::vector<NamedSurface> surfaces;
  CaseDescription description;
};

CaseData splitCase(vtkDataObject* input);

/// The surfaces of a polydata or of all polydata in a collection.
std::vector<NamedSurface> surfacesOf(vtkDataObject* input);

/// Latest modification of a data object and all that it is made of.
std::uint64_t modifiedTime(vtkDataObject* data);
}
