#include "Conversion/OutputErrors.h"

#include "Conversion/CaseData.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <limits>
#include <map>

namespace strata::conversion
{
namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

const char* const numberColumns[] = { "samples", "missing", "largest", "mean", "root_mean_square", "x", "y", "z",
  "claimed", "original_to_represented_lower", "original_to_represented_upper", "represented_to_original_lower",
  "represented_to_original_upper", "represented_volume", "original_volume", "relative_volume_error", "represented_mass",
  "original_mass", "relative_mass_error", "misclassified_volume", "misclassified_volume_error",
  "misclassified_near_gaps" };

/// A table of which each row fills some columns.
class Rows
{
public:
  using Numbers = std::map<std::string, double>;

  Rows()
  {
    for (const char* name : { "kind", "material", "other_material", "field" })
    {
      texts_.emplace_back(vtkSmartPointer<vtkStringArray>::New());
      texts_.back()->SetName(name);
    }
    for (const char* name : numberColumns)
    {
      numbers_.emplace_back(vtkSmartPointer<vtkDoubleArray>::New());
      numbers_.back()->SetName(name);
    }
  }

  void add(const std::vector<std::string>& texts, const Numbers& numbers)
  {
    for (std::size_t i = 0; i < texts_.size(); ++i)
    {
      texts_[i]->InsertNextValue(texts[i]);
    }
    for (const auto& column : numbers_)
    {
      const auto at = numbers.find(column->GetName());
      column->InsertNextValue(at == numbers.end() ? notANumber : at->second);
    }
  }

  void write(vtkTable* output) const
  {
    for (const auto& column : texts_)
    {
      output->AddColumn(column);
    }
    for (const auto& column : numbers_)
    {
      output->AddColumn(column);
    }
  }

private:
  std::vector<vtkSmartPointer<vtkStringArray>> texts_;
  std::vector<vtkSmartPointer<vtkDoubleArray>> numbers_;
};

void addDistances(const HausdorffDistance& distance, Rows::Numbers& numbers)
{
  numbers["original_to_represented_lower"] = distance.originalToRepresented.lower;
  numbers["original_to_represented_upper"] = distance.originalToRepresented.upper;
  numbers["represented_to_original_lower"] = distance.representedToOriginal.lower;
  numbers["represented_to_original_upper"] = distance.representedToOriginal.upper;
}

double claim(vtkFieldData* claims, const std::string& name)
{
  vtkDataArray* array = claims ? claims->GetArray(name.c_str()) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : notANumber;
}

double relative(double represented, double original)
{
  return original != 0.0 ? (represented - original) / original : notANumber;
}
}

void writeErrors(
  const RepresentationErrors& errors, const Representation& representation, vtkFieldData* claims, vtkTable* output)
{
  const auto material = [&](MaterialId m) { return representation.materials[static_cast<std::size_t>(m.value)].name; };
  Rows rows;
  for (const FieldErrorReport& report : errors.fields)
  {
    const std::string& field = representation.fields[static_cast<std::size_t>(report.field.value)].name;
    rows.add({ "field", material(report.material), "", field },
      { { "samples", static_cast<double>(report.samples) }, { "missing", static_cast<double>(report.missing) },
        { "largest", report.largest }, { "mean", report.mean }, { "root_mean_square", report.rootMeanSquare },
        { "x", report.where[0] }, { "y", report.where[1] }, { "z", report.where[2] },
        { "claimed", claim(claims, "achieved_field_error_" + field) } });
  }
  for (const InterfaceErrorReport& report : errors.interfaces)
  {
    Rows::Numbers numbers = { { "samples", static_cast<double>(report.vertices) },
      { "missing", static_cast<double>(report.missing) }, { "largest", report.largestVertexError },
      { "x", report.where[0] }, { "y", report.where[1] }, { "z", report.where[2] },
      { "claimed", claim(claims, "achieved_interface_error") } };
    addDistances(report.distance, numbers);
    rows.add({ "interface", material(report.positive), material(report.negative), "" }, numbers);
  }
  for (const RegionErrorReport& report : errors.regions)
  {
    Rows::Numbers numbers = { { "claimed", claim(claims, "achieved_region_error") } };
    addDistances(report.distance, numbers);
    rows.add({ "region", material(report.material), "", "" }, numbers);
  }
  for (const VolumeErrorReport& report : errors.volumes)
  {
    rows.add({ "volume", material(report.material), "", "" },
      { { "represented_volume", report.represented }, { "original_volume", report.original },
        { "relative_volume_error", relative(report.represented, report.original) },
        { "represented_mass", report.representedMass }, { "original_mass", report.originalMass },
        { "relative_mass_error", relative(report.representedMass, report.originalMass) } });
  }
  rows.add({ "misclassified", "", "", "" }, { { "misclassified_volume", errors.misclassifiedVolume },
                                              { "misclassified_volume_error", errors.misclassifiedVolumeError },
                                              { "misclassified_near_gaps", errors.misclassifiedNearGaps } });
  rows.write(output);
}
}
