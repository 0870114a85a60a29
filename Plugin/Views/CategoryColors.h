#ifndef CategoryColors_h
#define CategoryColors_h

#include <array>
#include <map>
#include <string>

class vtkSMProxy;

struct Category
{
  std::string name;
  std::array<double, 3> color; ///< red, green and blue in [0, 1]
};
using Categories = std::map<int, Category>;

/// Reads lines "<number><tab><name>", with a further "<tab>plain" for what should not stand out. A category's colour is
/// a function of its number and of that alone.
Categories readCategories(const std::string& legend);

/// Adds categories to those of a colour map and makes it categorical. Returns false, with nothing changed, if the map
/// has other names for them.
bool addCategories(vtkSMProxy* colorMap, const Categories& categories);

#endif
