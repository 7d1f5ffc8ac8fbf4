// SPDX-License-Identifier: GPL-2.0-or-later
// Ids of boundary faces. A face may be in several groups of the file (a
// physical group, a surface, a set of nodes); at most one of them may have a
// name in the .prm, which decides. Without a name the number of the file is the
// id, so that it can be seen in output; without a number it is 0.
//
// A group with a name must consist of boundary faces: one inside the body would
// be a condition that is silently not applied.

#include <base/names.h>
#include <base/text.h>

#include <problem/geometries/mesh_builder.h>
#include <problem/geometries/mesh_scan_formats.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>

namespace MixedCracks
{
  namespace
  {
    constexpr unsigned int nobody = std::numeric_limits<unsigned int>::max();

    bool
    same_label(const std::string &a, const std::string &b)
    {
      return a.size() == b.size() &&
             std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
               return std::tolower(static_cast<unsigned char>(x)) ==
                      std::tolower(static_cast<unsigned char>(y));
             });
    }



    bool
    stands_for(const BoundaryName &name, const MeshContents::Group &group)
    {
      return name.key == std::to_string(group.number) ||
             same_label(name.key, group.name);
    }



    // For each group the name that stands for it, if there is one. Returns
    // what is wrong.
    std::string
    find_names(const std::vector<BoundaryName>        &names,
               const std::vector<MeshContents::Group> &groups,
               std::vector<unsigned int>              &name_of_group)
    {
      name_of_group.assign(groups.size(), nobody);
      for (unsigned int g = 0; g < groups.size(); ++g)
        for (unsigned int n = 0; n < names.size(); ++n)
          if (stands_for(names[n], groups[g]))
          {
            if (name_of_group[g] != nobody)
              return "the boundary " + MeshScanning::in_words(groups[g]) +
                     " of the file has two names, '" +
                     names[name_of_group[g]].name + "' and '" + names[n].name +
                     "'";
            name_of_group[g] = n;
          }
      return "";
    }



    // Ids up to here are those of the file
    constexpr long int largest_id = 1000000000;

    dealii::types::boundary_id
    id_without_name(const std::vector<unsigned int>        &groups_of_face,
                    const std::vector<MeshContents::Group> &groups)
    {
      for (const unsigned int g : groups_of_face)
        if (groups[g].number >= 0 && groups[g].number <= largest_id)
          return static_cast<dealii::types::boundary_id>(groups[g].number);
      return 0;
    }
  } // namespace



  template <int dim>
  std::string
  MeshBuilder<dim>::check_inner_faces(
    const std::vector<BoundaryName> &names,
    const std::vector<unsigned int> &name_of_group) const
  {
    for (const auto &[face, groups] : groups_at)
    {
      const auto cells_there = faces_of_cells.find(face);
      if (cells_there != faces_of_cells.end() &&
          cells_there->second.n_cells == 1)
        continue;
      for (const unsigned int g : groups)
        if (name_of_group[g] != nobody)
          return "the boundary " + MeshScanning::in_words(contents.groups[g]) +
                 " (" + names[name_of_group[g]].name + ") has a line or face " +
                 (cells_there == faces_of_cells.end()
                    ? "that belongs to no cell"
                    : "inside the domain") +
                 ", with the nodes " + node_list(face);
    }
    return "";
  }



  template <int dim>
  std::string
  MeshBuilder<dim>::set_boundary_ids(
    const std::vector<BoundaryName> &names,
    dealii::Triangulation<dim>      &triangulation) const
  {
    std::vector<unsigned int> name_of_group;
    std::string problem = find_names(names, contents.groups, name_of_group);
    if (problem.empty())
      problem = check_inner_faces(names, name_of_group);
    if (!problem.empty())
      return problem;

    std::set<dealii::types::boundary_id>   present;
    static const std::vector<unsigned int> no_groups;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
      {
        if (!face->at_boundary())
          continue;
        Face nodes;
        for (const unsigned int v : face->vertex_indices())
          nodes.push_back(node_of_vertex[face->vertex_index(v)]);
        std::sort(nodes.begin(), nodes.end());
        const auto  known = groups_at.find(nodes);
        const auto &groups =
          known == groups_at.end() ? no_groups : known->second;
        unsigned int named = nobody;
        for (const unsigned int g : groups)
          if (const unsigned int n = name_of_group[g]; n != nobody)
          {
            if (named != nobody && named != n)
              return "the face with the nodes " + node_list(nodes) +
                     " is in two boundaries, " + names[named].key + " (" +
                     names[named].name + ") and " + names[n].key + " (" +
                     names[n].name + "); only one of them can have a name";
            named = n;
          }
        const auto id = named == nobody
                          ? id_without_name(groups, contents.groups)
                          : names[named].id;
        face->set_boundary_id(id);
        present.insert(id);
      }
    for (const BoundaryName &name : names)
      if (present.count(name.id) == 0)
        return "the boundary id " + name.key + " (" + name.name +
               ") is not in the file, which has " + known_boundaries();
    return "";
  }



  template <int dim>
  std::string
  MeshBuilder<dim>::known_boundaries() const
  {
    std::map<long int, std::string> numbered;
    std::set<std::string>           named;
    for (const auto &[face, use] : faces_of_cells)
    {
      if (use.n_cells != 1)
        continue;
      bool       has_number = false;
      const auto groups     = groups_at.find(face);
      if (groups != groups_at.end())
        for (const unsigned int g : groups->second)
        {
          const MeshContents::Group &group = contents.groups[g];
          if (group.number == MeshContents::Group::none)
            named.insert(MeshScanning::in_words(group));
          else
            numbered[group.number] = MeshScanning::in_words(group);
          has_number = has_number || group.number != MeshContents::Group::none;
        }
      if (!has_number)
        numbered.emplace(0, "0");
    }
    std::vector<std::string> ids;
    for (const auto &id : numbered)
      ids.push_back(id.second);
    return "the ids " + join_names(ids) +
           (named.empty()
              ? ""
              : " and the names " + join_names({named.begin(), named.end()}));
  }



#define INSTANTIATE(dim)                                                    \
  template std::string MeshBuilder<dim>::check_inner_faces(                 \
    const std::vector<BoundaryName> &, const std::vector<unsigned int> &)   \
    const;                                                                  \
  template std::string MeshBuilder<dim>::set_boundary_ids(                  \
    const std::vector<BoundaryName> &, dealii::Triangulation<dim> &) const; \
  template std::string MeshBuilder<dim>::known_boundaries() const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
