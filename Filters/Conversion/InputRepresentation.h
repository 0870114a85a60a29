#pragma once

#include "Model/Errors.h"
#include "Model/Representation.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace strata::conversion
{
/// A view of a representation in a grid, and what keeps its memory alive.
struct RepresentationInput
{
  Representation view;
  std::vector<std::shared_ptr<const void>> owners;
};

/// Views a grid that *Multiresolution Tetrahedra* made, also one saved and loaded again; arrays of other types than
/// its own are converted. Throws InvalidInput that says what is missing for a representation.
RepresentationInput readRepresentation(vtkDataObject* data);

/// The materials of these names; all with fields if no name is given. Throws InvalidInput for an unknown one.
MaterialSet chosenMaterials(const std::vector<std::string>& chosen, const Materials& materials);

/// The field of this name; the first one if the name is empty. Throws InvalidInput for an unknown one.
FieldId chosenField(const std::string& name, const std::vector<Field>& fields);
}
