#include "Conversion/InputFields.h"

#include "Conversion/InputArrays.h"
#include "Conversion/MaterialNames.h"
#include "Conversion/ValueConversion.h"

#include <algorithm>
#include <array>

namespace strata::conversion
{
namespace
{
/// What is taken where nobody says which field, in this order.
constexpr std::array<const char*, 3> defaultFields = { "density", "Density", "rho" };

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

  const FieldPlan* firstFloating() const { return floating_.empty() ? nullptr : find(floating_.front()); }

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

std::vector<FieldPlan> plansFor(const InputGrid& input, const CaseDescription& description,
  const SimulationOptions& options, const MaterialRoles& roles, const Materials& materials)
{
  const bool isCase = !description.fields.empty() && options.volumeFractionArrays.empty();
  const FieldCatalogue catalogue(input, materials, roles);
  const std::vector<FieldPlan> plans = isCase ? plansOfCase(input, description, materials) : catalogue.plans();
  if (!options.fieldArrays.empty())
  {
    return selected(plans, options.fieldArrays);
  }
  const auto has = [&](const std::string& name) { return contains(namesOf(plans), name); };
  const FieldPlan* active = catalogue.find(activeScalars(input));
  if (!isCase && active)
  {
    return { *active };
  }
  for (const char* name : defaultFields)
  {
    if (has(name))
    {
      return selected(plans, { name });
    }
  }
  if (isCase)
  {
    return { plans.front() };
  }
  const FieldPlan* first = catalogue.firstFloating();
  return first ? std::vector<FieldPlan>{ *first } : std::vector<FieldPlan>{};
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

SimulationField fieldOf(const InputGrid& input, const FieldPlan& plan, const Materials& materials, Warnings& warnings)
{
  SimulationField field;
  field.name = plan.name;
  field.association = plan.association;
  const bool separate = std::any_of(
    plan.perMaterial.begin(), plan.perMaterial.end(), [](const std::string& array) { return !array.empty(); });
  const ValueArray shared = separate ? ValueArray() : values(input, plan.association, plan.shared, &warnings);
  field.components = separate ? 0 : shared.components();
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    field.values.emplace_back();
    if (!materials[m].hasFields)
    {
      continue;
    }
    if (!separate)
    {
      field.values.back() = shared;
    }
    else if (!plan.perMaterial[m].empty())
    {
      field.values.back() = values(input, plan.association, plan.perMaterial[m], &warnings);
      const int components = field.values.back().components();
      if (field.components != 0 && components != field.components)
      {
        throw InvalidInput("The array '" + plan.perMaterial[m] + "' has " + std::to_string(components) +
                           " components; other materials' arrays of '" + plan.name + "' have " +
                           std::to_string(field.components));
      }
      field.components = components;
    }
  }
  field.components = std::max(field.components, 1);
  return field;
}
}

void readFields(const InputGrid& input, const CaseDescription& description, const SimulationOptions& options,
  const MaterialRoles& roles, Simulation& simulation, Warnings& warnings)
{
  const std::vector<FieldPlan> plans = plansFor(input, description, options, roles, simulation.materials);
  settleMaterials(description, options, plans, simulation.materials);
  for (std::size_t f = 0; f < plans.size() && options.readFields; ++f)
  {
    simulation.fields.push_back(fieldOf(input, plans[f], simulation.materials, warnings));
  }
}
}
