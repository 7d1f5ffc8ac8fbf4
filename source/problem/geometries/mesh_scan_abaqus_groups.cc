// SPDX-License-Identifier: GPL-2.0-or-later
// What the names of an Abaqus file stand for, once all of it has been read: a
// set may be used before it is listed.
//
// Sides of cells are counted from S1 in the order of sides_of(): in 2-d S1 is
// from node 1 to 2, and so on around; S1 of solids is the face of the nodes
// 1-2-3(-4).

#include <base/text.h>

#include <problem/geometries/mesh_scan_abaqus.h>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      // SS1, SS2, ... are known by their numbers, too
      long int
      surface_number(const std::string &name)
      {
        if (name.size() < 3 || name.size() > 11 ||
            upper_case(name.substr(0, 2)) != "SS" ||
            name.find_first_not_of("0123456789", 2) != std::string::npos)
          return MeshContents::Group::none;
        return std::stol(name.substr(2));
      }



      MeshProblem
      unlisted_element(const std::string &where, const long int element)
      {
        return MeshProblem(
          "has a surface or set with element " +
          std::to_string(element % MeshContents::numbers_per_body) +
          ", which it does not list (" + where + ")");
      }
    } // namespace



    void
    AbaqusReader::add_materials()
    {
      for (const auto &[set, material] : sections)
        if (const auto members = element_sets.find(upper_case(set));
            members != element_sets.end())
          for (const long int number : members->second.members)
            if (const auto element = elements.find(number);
                element != elements.end() && element->second.cell >= 0)
              contents.cells[static_cast<std::size_t>(element->second.cell)]
                .material = material;
    }



    // Elements of a lower dimension are skipped, but their sets name boundaries
    void
    AbaqusReader::add_element_groups()
    {
      for (const auto &labelled : element_sets)
        for (const long int number : labelled.second.members)
        {
          const auto element = elements.find(number);
          if (element == elements.end())
            throw unlisted_element(in_quotes(labelled.second.name), number);
          if (!element->second.face.empty())
            contents.faces.push_back({element->second.face,
                                      contents.group(MeshContents::Group::none,
                                                     labelled.second.name)});
        }
    }



    void
    AbaqusReader::add_node_groups()
    {
      for (const auto &labelled : node_sets)
      {
        const std::vector<long int> &members = labelled.second.members;
        if (members.empty())
          continue;
        const auto nodes = contents.indices_of(members.begin(), members.end());
        if (nodes.size() != members.size())
          throw MeshProblem("has a node set " +
                            in_quotes(labelled.second.name) +
                            " with nodes that it does not list");
        contents.node_sets.push_back(
          {nodes,
           contents.group(MeshContents::Group::none, labelled.second.name)});
      }
    }



    void
    AbaqusReader::add_side(const AbaqusSurfaceLine &surface,
                           const long int           number,
                           const unsigned int       group)
    {
      const auto element = elements.find(number);
      if (element == elements.end())
        throw unlisted_element(in_quotes(surface.name), number);
      if (element->second.cell < 0)
        throw MeshProblem(
          "has a surface " + in_quotes(surface.name) + " with element " +
          std::to_string(number % MeshContents::numbers_per_body) +
          ", which is none of the " + kind.name);
      const auto &nodes =
        contents.cells[static_cast<std::size_t>(element->second.cell)].nodes;
      const auto       &sides = sides_of(kind.dim, nodes.size());
      const std::size_t side  = static_cast<std::size_t>(surface.side);
      if (side >= sides.size())
        throw broken_line("side in a *SURFACE", surface.line);
      MeshContents::Face face{{}, group};
      for (const unsigned int place : sides[side])
        face.nodes.push_back(nodes[place]);
      contents.faces.push_back(face);
    }



    void
    AbaqusReader::add_surface(const AbaqusSurfaceLine &surface)
    {
      const bool            of_nodes = surface.side < 0;
      const auto           &sets     = of_nodes ? node_sets : element_sets;
      std::vector<long int> members  = integers_of(surface.what);
      for (long int &member : members)
        member += surface.scope.base;
      if (members.empty())
      {
        const AbaqusSet *set = find_set(sets, surface.scope, surface.what);
        if (set == nullptr)
          throw MeshProblem(
            "has a surface " + in_quotes(surface.name) +
            " of a set that it does not list: " + in_quotes(surface.line));
        members = set->members;
      }
      const unsigned int group =
        contents.group(surface_number(surface.name), surface.name);
      if (of_nodes)
        contents.node_sets.push_back(
          {contents.indices_of(members.begin(), members.end()), group});
      else
        for (const long int number : members)
          add_side(surface, number, group);
    }



    void
    AbaqusReader::finish()
    {
      if (parts.size() > 1 && instances.empty())
        throw MeshProblem("has " + std::to_string(parts.size()) +
                          " parts and no *INSTANCE that says where they stand");
      if (parts.size() == 1 && instances.empty())
        place_part(parts.begin()->first);
      if (contents.nodes.empty() || elements.empty())
        throw MeshProblem(
          "is an Abaqus file without " +
          std::string(contents.nodes.empty() ? "*NODE" : "*ELEMENT") +
          " lines");
      if (contents.cells.empty())
      {
        bool has_faces = false;
        for (const auto &element : elements)
          has_faces = has_faces || !element.second.face.empty();
        throw no_cells(has_faces, kind);
      }
      add_materials();
      add_element_groups();
      add_node_groups();
      for (const AbaqusSurfaceLine &surface : surfaces)
        add_surface(surface);
      join_bodies();
    }
  } // namespace MeshScanning
} // namespace MixedCracks
