// SPDX-License-Identifier: GPL-2.0-or-later
// Ids of boundary faces. A face may be in several groups of the file (a
// physical group, a surface, a set of nodes) and has the names of all of them:
// that of the .prm where it gives one, or else that of the file. What names a
// face has is what its id tells: each combination that occurs has an id, and a
// name stands for the ids of all combinations that it is part of. Without any
// name the number of the file is the id; without a number it is 0.
//
// A group with a name in the .prm must consist of boundary faces: one inside
// the body would be a condition that is silently not applied. Other groups that
// do not are no boundaries.

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
    std::vector<unsigned int>
    find_names(const std::vector<BoundaryName>        &names,
               const std::vector<MeshContents::Group> &groups)
    {
      std::vector<unsigned int> name_of_group(groups.size(), nobody);
      for (unsigned int g = 0; g < groups.size(); ++g)
        for (unsigned int n = 0; n < names.size(); ++n)
          if (stands_for(names[n], groups[g]))
          {
            if (name_of_group[g] != nobody)
              throw MeshProblem(
                "the boundary " + MeshScanning::in_words(groups[g]) +
                " of the file has two names, '" + names[name_of_group[g]].name +
                "' and '" + names[n].name + "'");
            name_of_group[g] = n;
          }
      return name_of_group;
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



    // Ids from here on are those of faces with several names, or with one that
    // the .prm does not give
    constexpr dealii::types::boundary_id first_shared_id = 1500000000;

    using Names = std::vector<std::string>;

    // By the names of a face; one that the .prm gives has the id that it is to
    // have there.
    template <typename Faces>
    std::map<Names, dealii::types::boundary_id>
    ids_of_names(const Faces &names_at, const std::vector<BoundaryName> &given)
    {
      std::map<Names, dealii::types::boundary_id> ids;
      for (const auto &[face, names] : names_at)
        if (!names.empty())
          ids[names] = 0;
      dealii::types::boundary_id next = first_shared_id;
      for (auto &[names, id] : ids)
      {
        id = next++;
        if (names.size() == 1)
          for (const BoundaryName &name : given)
            if (name.name == names[0])
              id = name.id;
      }
      return ids;
    }



    template <typename Faces>
    FileBoundaries
    boundaries_of(const Faces                                       &names_at,
                  const std::map<Names, dealii::types::boundary_id> &ids,
                  const std::vector<BoundaryName>                   &given)
    {
      FileBoundaries                     result;
      std::map<std::string, std::size_t> n_faces;
      for (const auto &[face, names] : names_at)
        for (const std::string &name : names)
          ++n_faces[name];
      for (const BoundaryName &name : given)
        n_faces[name.name] = 0; // before those of the file
      for (const auto &[names, id] : ids)
      {
        for (const std::string &name : names)
          result.ids[name].insert(id);
        result.names[id] =
          *std::min_element(names.begin(),
                            names.end(),
                            [&](const std::string &a, const std::string &b) {
                              return n_faces.at(a) < n_faces.at(b);
                            });
      }
      return result;
    }
  } // namespace



  template <int dim>
  void
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
          throw MeshProblem(
            "the boundary " + MeshScanning::in_words(contents.groups[g]) +
            " (" + names[name_of_group[g]].name + ") has a line or face " +
            (cells_there == faces_of_cells.end() ? "that belongs to no cell"
                                                 : "inside the domain") +
            ", with the nodes " + node_list(face));
    }
  }



  // A group that has no name in the .prm goes by that of the file, unless it
  // cannot be a boundary or the .prm calls another one so.
  template <int dim>
  std::vector<std::string>
  MeshBuilder<dim>::names_of_groups(
    const std::vector<BoundaryName> &names,
    const std::vector<unsigned int> &name_of_group) const
  {
    std::vector<bool> is_boundary(contents.groups.size(), true);
    for (const auto &[face, groups] : groups_at)
    {
      const auto cells_there = faces_of_cells.find(face);
      if (cells_there == faces_of_cells.end() ||
          cells_there->second.n_cells != 1)
        for (const unsigned int g : groups)
          is_boundary[g] = false;
    }
    std::vector<std::string> result(contents.groups.size());
    for (std::size_t g = 0; g < result.size(); ++g)
      if (name_of_group[g] != nobody)
        result[g] = names[name_of_group[g]].name;
      else if (is_boundary[g])
      {
        result[g] = single_spaced(contents.groups[g].name);
        for (const BoundaryName &name : names)
          if (name.name == result[g])
            result[g].clear();
      }
    return result;
  }



  template <int dim>
  std::map<std::vector<unsigned int>, std::vector<std::string>>
  MeshBuilder<dim>::names_of_faces(
    const std::vector<std::string> &group_names) const
  {
    std::map<Face, std::vector<std::string>> result;
    for (const auto &[face, groups] : groups_at)
      if (const auto cells_there = faces_of_cells.find(face);
          cells_there != faces_of_cells.end() &&
          cells_there->second.n_cells == 1)
      {
        std::set<std::string> names;
        for (const unsigned int g : groups)
          if (!group_names[g].empty())
            names.insert(group_names[g]);
        result[face].assign(names.begin(), names.end());
      }
    return result;
  }



  // '0 = sides' names the faces that are in no group.
  template <int dim>
  void
  MeshBuilder<dim>::name_the_rest(
    const std::vector<BoundaryName>            &names,
    const std::set<dealii::types::boundary_id> &without_name,
    FileBoundaries                             &boundaries) const
  {
    for (const BoundaryName &name : names)
      if (boundaries.ids.count(name.name) == 0)
      {
        if (without_name.count(name.id) == 0)
          throw MeshProblem("the boundary id " + name.key + " (" + name.name +
                            ") is not in the file, which has " +
                            known_boundaries());
        boundaries.ids[name.name].insert(name.id);
        boundaries.names[name.id] = name.name;
      }
  }



  template <int dim>
  FileBoundaries
  MeshBuilder<dim>::set_boundary_ids(
    const std::vector<BoundaryName> &names,
    dealii::Triangulation<dim>      &triangulation) const
  {
    const std::vector<unsigned int> name_of_group =
      find_names(names, contents.groups);
    check_inner_faces(names, name_of_group);

    const auto names_at = names_of_faces(names_of_groups(names, name_of_group));
    const auto ids      = ids_of_names(names_at, names);
    FileBoundaries boundaries = boundaries_of(names_at, ids, names);
    std::set<dealii::types::boundary_id> without_name;
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
      {
        if (!face->at_boundary())
          continue;
        Face nodes;
        for (const unsigned int v : face->vertex_indices())
          nodes.push_back(node_of_vertex[face->vertex_index(v)]);
        std::sort(nodes.begin(), nodes.end());
        const auto known = names_at.find(nodes);
        if (known != names_at.end() && !known->second.empty())
        {
          face->set_boundary_id(ids.at(known->second));
          continue;
        }
        face->set_boundary_id(
          known == names_at.end()
            ? 0
            : id_without_name(groups_at.at(nodes), contents.groups));
        without_name.insert(face->boundary_id());
      }
    name_the_rest(names, without_name, boundaries);
    return boundaries;
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
  template FileBoundaries MeshBuilder<dim>::set_boundary_ids(               \
    const std::vector<BoundaryName> &, dealii::Triangulation<dim> &) const; \
  template std::string MeshBuilder<dim>::known_boundaries() const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
