// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/coordinates.h>
#include <base/errors.h>
#include <base/names.h>
#include <base/text.h>

#include <problem/boundary_entries.h>
#include <problem/named_conditions.h>

namespace MixedCracks
{
  using namespace dealii;

  const std::vector<std::string> &
  entry_variables()
  {
    static const std::vector<std::string> names = {"x", "y", "z", "t"};
    return names;
  }



  namespace
  {
    // components a name stands for; @p more: what stands for component dim
    template <int dim>
    std::vector<unsigned int>
    components_of(const std::string &name,
                  const std::string &more,
                  const std::string &parameter)
    {
      std::vector<std::string> allowed = {"x", "y"};
      if (dim == 3)
        allowed.push_back("z");
      for (unsigned int d = 0; d < dim; ++d)
        if (name == allowed[d])
          return {d};
      if (name == "all")
      {
        std::vector<unsigned int> all;
        for (unsigned int d = 0; d < dim; ++d)
          all.push_back(d);
        return all;
      }
      if (!more.empty() && name == more)
        return {dim};
      allowed.push_back("all");
      if (!more.empty())
        allowed.push_back(more);
      if (more == entry_of_phase_field)
        allowed.push_back(Rotation<dim>::form());
      throw InputError(parameter +
                       ": component: " + unknown_name_message(name, allowed));
    }



    // a second value of one component on one boundary would be lost
    template <int dim>
    void
    require_new(const std::vector<BoundaryEntry<dim>> &entries,
                const std::string                     &boundary,
                const unsigned int                     component,
                const std::string                     &found,
                const std::string                     &parameter)
    {
      for (const BoundaryEntry<dim> &earlier : entries)
        if (earlier.boundary == boundary && earlier.component == component)
          throw InputError(
            parameter + ": found '" + found +
            "', a second entry for a component that has one. "
            "Allowed is one for each component" +
            (boundary.empty() ? "." : " of '" + boundary + "'."));
    }



    template <int dim>
    PointEntry<dim>
    point_entry(const BoundaryEntry<dim> &entry,
                const std::string        &parameter,
                const bool                with_sets)
    {
      PointEntry<dim> at{{}, entry.component, entry.expression, ""};
      if (with_sets && begins_as_name(entry.boundary))
      {
        at.set = single_spaced(entry.boundary);
        return at;
      }
      at.point = read_point<dim>(entry.boundary, parameter);
      return at;
    }
  } // namespace



  template <int dim>
  std::vector<BoundaryEntry<dim>>
  read_entries(const std::string &text,
               const bool         with_boundary,
               const std::string &more,
               const std::string &parameter)
  {
    std::vector<BoundaryEntry<dim>> result;
    for (const std::string &entry : split_list(text, ';'))
    {
      std::vector<std::string> parts = split_list(entry, ':');
      if (more == entry_of_phase_field && parts.size() == 2 &&
          parts[1] == "symmetry")
      {
        const unsigned int component = BoundaryEntry<dim>::symmetry;
        require_new(result, parts[0], component, entry, parameter);
        result.push_back({parts[0],
                          component,
                          std::make_shared<const Expression>(
                            "0", entry_variables(), parameter)});
        continue;
      }
      if (!with_boundary)
        parts.insert(parts.begin(), "");
      if (parts.size() != 3)
        throw InputError(
          parameter + ": found '" + entry + "', allowed is '" +
          (with_boundary ? "boundary : " : "") + "component : expression'" +
          (more == entry_of_phase_field ? " or 'boundary : symmetry'" : "") +
          ", several separated by ';'.");
      const auto expression = std::make_shared<const Expression>(
        parts[2], entry_variables(), parameter);
      const auto rotation = more == entry_of_phase_field
                              ? Rotation<dim>::read(parts[1], parameter)
                              : nullptr;
      for (const unsigned int component :
           rotation ? rotation->components()
                    : components_of<dim>(parts[1], more, parameter))
      {
        require_new(result, parts[0], component, entry, parameter);
        result.push_back({parts[0], component, expression, rotation});
      }
    }
    return result;
  }



  // however the point is written
  template <int dim>
  std::vector<PointEntry<dim>>
  point_entries(const std::vector<BoundaryEntry<dim>> &entries,
                const std::string                     &parameter,
                const bool                             with_sets)
  {
    std::vector<PointEntry<dim>> result;
    for (const BoundaryEntry<dim> &entry : entries)
    {
      const PointEntry<dim> at = point_entry(entry, parameter, with_sets);
      for (const PointEntry<dim> &earlier : result)
        if (earlier.point == at.point && earlier.set == at.set &&
            earlier.component == at.component)
          throw InputError(parameter + ": found '" + entry.boundary +
                           "' twice for a component. Allowed is one entry "
                           "for each component of a point.");
      result.push_back(at);
    }
    return result;
  }



#define INSTANTIATE(dim)                                                  \
  template std::vector<BoundaryEntry<dim>> read_entries(                  \
    const std::string &, bool, const std::string &, const std::string &); \
  template std::vector<PointEntry<dim>> point_entries(                    \
    const std::vector<BoundaryEntry<dim>> &, const std::string &, bool);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
