#include "Conversion/InputFields.h"

#include "Conversion/CurvedValues.h"
#include "Conversion/DefaultField.h"
#include "Conversion/InputArrays.h"
#include "Conversion/MaterialNames.h"
#include "Conversion/ValueConversion.h"

#include <algorithm>
#include <sstream>

namespace strata::conversion
{
namespace
{
/// A field and its arrays: one per material, or "" where it has none of its own, and one for all.
struct FieldPlan
{
  std::string name;
  Association association = Association::Cells;
  std::vector<std::string> perMaterial;
  std::string shared;
};

bool contains(const std::vector<std::string>& list, const std::string& name)
{
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// How the names of a material's own arrays end: `density_block`, `Mass for Armor Plate`, and CTH's `Mass (g) - 3` of
/// `Material 3`.
std::vector<std::string> suffixesOf(const std::string& material)
{
  std::vector<std::string> result = { "_" + material, " for " + material };
  const std::string numbered = "Material ";
  if (material.compare(0, numbered.size(), numbered) == 0)
  {
    result.push_back(" - " + material.substr(numbered.size()));
  }
  return result;
}

/// All fields that the arrays of cells or points make up, per-material ones taken together.
class FieldCatalogue
{
public:
  FieldCatalogue(const InputGrid& input, const Materials& materials, const MaterialRoles& roles) : materials_(materials)
  {
    for (const Association association : { Association::Cells, Association::Points })
    {
      for (const ArrayInfo& array : arraysOf(input, association))
      {
        if (!contains(roles.arrays, array.name) && !materialOfFractions(array.name) && !isService(array.name))
        {
          add(array, association);
        }
      }
    }
  }

  const std::vector<FieldPlan>& plans() const { return plans_; }

  /// The field of that name, or that an array of that name belongs to; null if there is none.
  const FieldPlan* find(const std::string& name) const
  {
    const auto at = std::find_if(plans_.begin(), plans_.end(),
      [&](const FieldPlan& plan) { return plan.name == name || contains(plan.perMaterial, name); });
    return name.empty() || at == plans_.end() ? nullptr : &*at;
  }

  /// The fields that have values of a floating type.
  std::vector<FieldPlan> floating() const
  {
    std::vector<FieldPlan> result;
    std::copy_if(plans_.begin(), plans_.end(), std::back_inserter(result), [&](const FieldPlan& plan) {
      return contains(floating_, plan.shared) ||
             std::any_of(plan.perMaterial.begin(), plan.perMaterial.end(),
               [&](const std::string& array) { return contains(floating_, array); });
    });
    return result;
  }

private:
  static bool isService(const std::string& name) { return name.compare(0, 3, "vtk") == 0; }

  /// A material and the end of the name by which an array is its own.
  struct Owner
  {
    std::size_t material;
    std::string suffix;
  };

  /// The material whose own array of a field this is, by the longest end of the name; without suffix if it is none's.
  Owner ownerOf(const std::string& array) const
  {
    Owner best{ materials_.size(), "" };
    for (std::size_t m = 0; m < materials_.size(); ++m)
    {
      for (const std::string& suffix : suffixesOf(materials_[m].name))
      {
        const bool ends =
          array.size() > suffix.size() && array.compare(array.size() - suffix.size(), suffix.size(), suffix) == 0;
        if (ends && suffix.size() > best.suffix.size())
        {
          best = { m, suffix };
        }
      }
    }
    return best;
  }

  FieldPlan& planOf(const std::string& name, Association association)
  {
    for (FieldPlan& plan : plans_)
    {
      if (plan.name == name && plan.association == association)
      {
        return plan;
      }
    }
    plans_.push_back({ name, association, std::vector<std::string>(materials_.size()), "" });
    return plans_.back();
  }

  void add(const ArrayInfo& array, Association association)
  {
    const Owner owner = ownerOf(array.name);
    if (!owner.suffix.empty())
    {
      const std::string field = array.name.substr(0, array.name.size() - owner.suffix.size());
      planOf(field, association).perMaterial[owner.material] = array.name;
    }
    else
    {
      planOf(array.name, association).shared = array.name;
    }
    if (array.floating)
    {
      floating_.push_back(array.name);
    }
  }

  const Materials& materials_;
  std::vector<FieldPlan> plans_;
  std::vector<std::string> floating_;
};

/// The fields as a case file lists them.
std::vector<FieldPlan> plansOfCase(
  const InputGrid& input, const CaseDescription& description, const Materials& materials)
{
  std::vector<FieldPlan> plans;
  for (const CaseField& entry : description.fields)
  {
    auto plan = std::find_if(plans.begin(), plans.end(), [&](const FieldPlan& p) { return p.name == entry.field; });
    if (plan == plans.end())
    {
      plans.push_back({ entry.field, Association::Cells, std::vector<std::string>(materials.size()), "" });
      plan = std::prev(plans.end());
    }
    const bool inCells = find(arraysOf(input, Association::Cells), entry.array) != nullptr;
    if (!inCells && !find(arraysOf(input, Association::Points), entry.array))
    {
      throw InvalidInput("The array '" + entry.array + "' of the field '" + entry.field + "' is missing");
    }
    plan->association = inCells ? Association::Cells : Association::Points;
    for (std::size_t m = 0; m < materials.size(); ++m)
    {
      if (materials[m].name == entry.material)
      {
        plan->perMaterial[m] = entry.array;
      }
    }
    plan->shared = entry.material.empty() ? entry.array : plan->shared;
  }
  return plans;
}

std::vector<std::string> namesOf(const std::vector<FieldPlan>& plans)
{
  std::vector<std::string> result;
  for (const FieldPlan& plan : plans)
  {
    result.push_back(plan.name);
  }
  return result;
}

std::vector<FieldPlan> selected(const std::vector<FieldPlan>& plans, const std::vector<std::string>& names)
{
  std::vector<FieldPlan> result;
  for (const std::string& name : names)
  {
    const auto at = std::find_if(plans.begin(), plans.end(),
      [&](const FieldPlan& plan) { return plan.name == name || contains(plan.perMaterial, name); });
    if (at == plans.end())
    {
      throw InvalidInput("There is no field '" + name + "'. Fields: " + listed(namesOf(plans)));
    }
    if (!contains(namesOf(result), at->name))
    {
      result.push_back(*at);
    }
  }
  return result;
}

int orderOf(const FieldPlan& plan, bool mixedMaterials)
{
  const bool ownArrays = std::any_of(
    plan.perMaterial.begin(), plan.perMaterial.end(), [](const std::string& array) { return !array.empty(); });
  return defaultOrder({ plan.name, ownArrays, mixedMaterials });
}

/// The field that is taken where nobody says which: the active scalars', else the first by its name; none if there
/// are none.
std::vector<FieldPlan> defaultPlan(
  const std::vector<FieldPlan>& plans, const FieldPlan* active, const Simulation& simulation)
{
  const bool mixed = !simulation.fractions.empty();
  if (active && orderOf(*active, mixed) < lastDefaultOrder)
  {
    return { *active };
  }
  const auto first = std::min_element(plans.begin(), plans.end(),
    [&](const FieldPlan& a, const FieldPlan& b) { return orderOf(a, mixed) < orderOf(b, mixed); });
  return first == plans.end() ? std::vector<FieldPlan>{} : std::vector<FieldPlan>{ *first };
}

std::vector<FieldPlan> plansFor(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, const MaterialRoles& roles, const Simulation& simulation)
{
  const bool isCase = !description.fields.empty() && options.volumeFractionArrays.empty();
  const FieldCatalogue catalogue(input, simulation.materials, roles);
  const std::vector<FieldPlan> plans =
    isCase ? plansOfCase(input, description, simulation.materials) : catalogue.plans();
  if (!options.fieldArrays.empty())
  {
    return selected(plans, options.fieldArrays);
  }
  return isCase ? defaultPlan(plans, nullptr, simulation)
                : defaultPlan(catalogue.floating(), catalogue.find(activeScalars(input)), simulation);
}

/// Which materials have fields: those that the user or the case says, else all but empty space.
void settleMaterials(const CaseDescription& description, const SimulationOptions& options,
  const std::vector<FieldPlan>& plans, Materials& materials)
{
  const std::vector<std::string>& without = options.materialsWithoutFields;
  for (const std::string& name : without)
  {
    if (std::none_of(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; }))
    {
      std::vector<std::string> known;
      std::transform(
        materials.begin(), materials.end(), std::back_inserter(known), [](const Material& m) { return m.name; });
      throw InvalidInput("There is no material '" + name + "' (MaterialsWithoutFields). Materials: " + listed(known));
    }
  }
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    Material& material = materials[m];
    const bool ownArrays =
      std::any_of(plans.begin(), plans.end(), [&](const FieldPlan& plan) { return !plan.perMaterial[m].empty(); });
    const auto said = std::find_if(description.materials.begin(), description.materials.end(),
      [&](const Material& other) { return other.name == material.name; });
    if (!without.empty())
    {
      material.hasFields = material.hasFields && !contains(without, material.name);
    }
    else if (said != description.materials.end())
    {
      material.hasFields = said->hasFields;
    }
    else
    {
      material.hasFields = material.hasFields && (ownArrays || !isEmptySpace(material.name));
    }
  }
}

/// A field's arrays as the materials have them.
class FieldValues
{
public:
  FieldValues(const InputGrid& input, const FieldPlan& plan, const Simulation& simulation, Warnings& warnings) :
    input_(input), plan_(plan), simulation_(simulation), warnings_(warnings)
  {}

  /// An array's values for a material. On curved cells a point may have another value for each material.
  ValueArray of(const std::string& array, std::size_t material)
  {
    if (plan_.association == Association::Points && !input_.curved.empty())
    {
      return onCurvedCells(array, material);
    }
    if (!values_ || array != read_)
    {
      values_ = values(input_, plan_.association, array, &warnings_);
      read_ = array;
    }
    return values_;
  }

  /// Says what curved cells and values that cells don't share come to.
  void warn() const
  {
    std::ostringstream text;
    if (jump_ > 0.0)
    {
      text << "'" << plan_.name << "' differs by up to " << jump_
           << " between cells of one material where they meet; the mean is taken";
      warnings_.push_back(text.str());
    }
    if (deviation_ > 0.0)
    {
      std::ostringstream curved;
      curved << "'" << plan_.name << "' in the curved cells lies within " << deviation_ << " of its linear pieces";
      warnings_.push_back(curved.str());
    }
  }

  double deviation() const { return jump_ + deviation_; }

private:
  ValueArray onCurvedCells(const std::string& array, std::size_t material)
  {
    const bool isNew = array != read_;
    const BlockArrays arrays = blockArrays(input_, Association::Points, array, isNew ? &warnings_ : nullptr);
    if (isNew)
    {
      deviation_ = std::max(deviation_, curvedDeviation(input_, arrays));
      read_ = array;
    }
    CurvedValues found = curvedValues(input_, arrays, simulation_.materialIds, static_cast<std::int32_t>(material));
    jump_ = std::max(jump_, found.largestJump);
    return std::move(found.values);
  }

  const InputGrid& input_;
  const FieldPlan& plan_;
  const Simulation& simulation_;
  Warnings& warnings_;
  std::string read_;
  ValueArray values_;
  double jump_ = 0.0;
  double deviation_ = 0.0;
};

SimulationField fieldOf(
  const InputGrid& input, const FieldPlan& plan, const Simulation& simulation, Warnings& warnings, double& deviation)
{
  SimulationField field;
  field.name = plan.name;
  field.association = plan.association;
  field.components = 0;
  const bool separate = std::any_of(
    plan.perMaterial.begin(), plan.perMaterial.end(), [](const std::string& array) { return !array.empty(); });
  FieldValues arrays(input, plan, simulation, warnings);
  for (std::size_t m = 0; m < simulation.materials.size(); ++m)
  {
    field.values.emplace_back();
    const std::string& array = separate ? plan.perMaterial[m] : plan.shared;
    if (!simulation.materials[m].hasFields || array.empty())
    {
      continue;
    }
    field.values.back() = arrays.of(array, m);
    const int components = field.values.back().components();
    if (field.components != 0 && components != field.components)
    {
      throw InvalidInput("The array '" + array + "' has " + std::to_string(components) +
                         " components; other materials' arrays of '" + plan.name + "' have " +
                         std::to_string(field.components));
    }
    field.components = components;
  }
  arrays.warn();
  deviation = arrays.deviation();
  field.components = std::max(field.components, 1);
  return field;
}
}

std::vector<double> readFields(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, const MaterialRoles& roles, Simulation& simulation, Warnings& warnings)
{
  std::vector<double> deviations;
  const std::vector<FieldPlan> plans = plansFor(input, description, options, roles, simulation);
  settleMaterials(description, options, plans, simulation.materials);
  for (std::size_t f = 0; f < plans.size() && options.readFields; ++f)
  {
    deviations.push_back(0.0);
    simulation.fields.push_back(fieldOf(input, plans[f], simulation, warnings, deviations.back()));
  }
  return deviations;
}
}
