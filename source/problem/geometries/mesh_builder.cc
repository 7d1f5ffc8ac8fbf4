// SPDX-License-Identifier: GPL-2.0-or-later
// From the contents of a mesh file to a triangulation. What a file can get
// wrong is looked for here, since deal.II would abort, or go on with a mesh
// that is none:
//
//   nodes that do not lie in a plane z = const, for a mesh in 2-d
//   cells that are flat, twisted or not convex (mesh_cells.cc)
//   a cell that is listed twice
//   a face of three cells
//   a face that two cells see in different orders: twisted
//
// Faces are known by the sorted indices of their nodes. Four nodes can stand
// around a quadrilateral in three ways; which one it is, the corner opposite to
// the least index tells.

#include <base/ranges.h>

#include <problem/geometries/checks.h>
#include <problem/geometries/mesh_builder.h>
#include <problem/geometries/mesh_cells.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace MixedCracks
{
  namespace
  {
    // of the size of the body
    constexpr double flatness = 1e-8;

    // Of a quadrilateral the corner across from that of the least number: with
    // the set of corners it tells in which order they stand.
    unsigned int
    across_from_first(const std::vector<unsigned int> &around)
    {
      const auto first = std::min_element(around.begin(), around.end());
      return around[(static_cast<std::size_t>(first - around.begin()) +
                     around.size() / 2) %
                    around.size()];
    }
  } // namespace



  template <int dim>
  std::string
  MeshBuilder<dim>::node_list(const Face &face) const
  {
    std::string text;
    for (const unsigned int node : face)
      if (contents.nodes[node].number != MeshContents::Node::none)
        text += (text.empty() ? "" : ", ") +
                std::to_string(contents.nodes[node].number);
    return text.empty() ? "made by cutting" : text;
  }



  // In 2-d the third coordinate is dropped, which must not fold the mesh.
  template <int dim>
  void
  MeshBuilder<dim>::check_plane() const
  {
    if (dim == 3)
      return;
    dealii::Point<3> lower =
      contents.nodes[contents.cells[0].nodes[0]].position;
    dealii::Point<3> upper = lower;
    for (const MeshContents::Cell &cell : contents.cells)
      for (const unsigned int node : cell.nodes)
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double x = contents.nodes[node].position[d];
          lower[d]       = std::min(lower[d], x);
          upper[d]       = std::max(upper[d], x);
        }
    const double size     = lower.distance(upper);
    const char  *planes[] = {"y-z", "x-z"};
    if (upper[2] - lower[2] <= flatness * size)
      return;
    for (unsigned int d = 0; d < 2; ++d)
      if (upper[d] - lower[d] <= flatness * size)
        throw MeshProblem(std::string("lies in the ") + planes[d] + " plane (" +
                          "xy"[d] + " = " + number_text(lower[d]) +
                          " at every node); turn it into the x-y plane");
    throw MeshProblem(
      "is not flat: its nodes go from z = " + number_text(lower[2]) +
      " to z = " + number_text(upper[2]) +
      ", and a mesh for 2-d lies in the x-y plane");
  }



  template <int dim>
  void
  MeshBuilder<dim>::collect_cells()
  {
    std::map<Face, long int> known;
    for (const MeshContents::Cell &listed : contents.cells)
    {
      MeshContents::Cell cell = listed;
      orient_cell<dim>(contents, cell);
      Face all = cell.nodes;
      std::sort(all.begin(), all.end());
      const auto [twin, is_new] = known.emplace(all, cell.material);
      if (!is_new)
        throw MeshProblem(
          "lists a cell twice, with the nodes " + node_list(all) +
          (twin->second == cell.material
             ? ""
             : " and the materials " + std::to_string(twin->second) + " and " +
                 std::to_string(cell.material) +
                 ": is it in two physical groups? A cell has one "
                 "material"));
      for (const Face &around : faces_of_cell<dim>(cell))
      {
        Face face = around;
        std::sort(face.begin(), face.end());
        const unsigned int opposite = across_from_first(around);
        const auto [known_face, first] =
          faces_of_cells.emplace(face, FaceOfCells{0, opposite});
        if (++known_face->second.n_cells > 2)
          throw MeshProblem("has three cells at one face, with the nodes " +
                            node_list(face));
        if (!first && known_face->second.opposite != opposite)
          throw MeshProblem(
            "has two cells that meet in a twisted face, with the nodes " +
            node_list(face));
      }
      add_cell(cell);
    }
  }



  // The file counts corners around, deal.II in pairs. Nodes that no cell uses
  // become no vertices.
  template <int dim>
  void
  MeshBuilder<dim>::add_cell(const MeshContents::Cell &cell)
  {
    static constexpr unsigned int places[] = {0, 1, 3, 2, 4, 5, 7, 6};
    vertex_of_node.resize(contents.nodes.size(),
                          dealii::numbers::invalid_unsigned_int);
    dealii::CellData<dim> data;
    for (unsigned int v = 0; v < cell.nodes.size(); ++v)
    {
      const unsigned int node = cell.nodes[places[v]];
      if (vertex_of_node[node] == dealii::numbers::invalid_unsigned_int)
      {
        vertex_of_node[node] = static_cast<unsigned int>(vertices.size());
        node_of_vertex.push_back(node);
        vertices.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          vertices.back()[d] = contents.nodes[node].position[d];
      }
      data.vertices[v] = vertex_of_node[node];
    }
    data.material_id = static_cast<dealii::types::material_id>(cell.material);
    cells.push_back(data);
  }



  template <int dim>
  void
  MeshBuilder<dim>::collect_groups()
  {
    const auto add = [&](const Face &face, const unsigned int group) {
      std::vector<unsigned int> &groups = groups_at[face];
      if (!contains(groups, group))
        groups.push_back(group);
    };
    for (const MeshContents::Face &listed : contents.faces)
    {
      Face face = listed.nodes;
      std::sort(face.begin(), face.end());
      add(face, listed.group);
    }
    for (const MeshContents::NodeSet &set : contents.node_sets)
    {
      std::vector<bool> in_set(contents.nodes.size(), false);
      for (const unsigned int node : set.nodes)
        in_set[node] = true;
      for (const auto &[face, use] : faces_of_cells)
        if (use.n_cells == 1 &&
            all_of(face, [&](const unsigned int node) { return in_set[node]; }))
          add(face, set.group);
    }
  }



  template <int dim>
  void
  MeshBuilder<dim>::build(dealii::Triangulation<dim> &triangulation)
  {
    check_plane();
    collect_cells();
    try
    {
      dealii::GridTools::consistently_order_cells(cells);
      triangulation.create_triangulation(vertices, cells, {});
    }
    catch (const std::exception &)
    {
      throw MeshProblem(
        "has cells that do not fit together (a face twisted between its "
        "cells, or edges that cannot be given directions)");
    }
    collect_groups();
  }



  template class MeshBuilder<2>;
  template class MeshBuilder<3>;
} // namespace MixedCracks
