// SPDX-License-Identifier: GPL-2.0-or-later
// Connected parts of the body: cells that share a face hang together (flood
// fill), parts that share only a vertex are hinged there, in space also along
// an edge, by its two vertices. Groups are parts joined by hinges, found as
// sets with union-find: root[root[x]] halves the paths.

#include <discretization/body_parts.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;
  } // namespace



  template <int dim>
  BodyParts<dim>::BodyParts(const Triangulation<dim> &triangulation)
    : part_of_cell(triangulation.n_cells(0), none)
  {
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (part_of_cell[cell->index()] == none)
        flood(cell);
    if (n > 1)
      find_hinges(triangulation);
  }



  template <int dim>
  void
  BodyParts<dim>::flood(const typename Triangulation<dim>::cell_iterator &seed)
  {
    std::vector<typename Triangulation<dim>::cell_iterator> front = {seed};
    part_of_cell[seed->index()]                                   = n;
    boxes.push_back(seed->bounding_box());
    while (!front.empty())
    {
      const auto cell = front.back();
      front.pop_back();
      boxes[n].merge_with(cell->bounding_box());
      for (const unsigned int f : cell->face_indices())
        if (!cell->at_boundary(f) &&
            part_of_cell[cell->neighbor(f)->index()] == none)
        {
          part_of_cell[cell->neighbor(f)->index()] = n;
          front.push_back(cell->neighbor(f));
        }
    }
    ++n;
  }



  template <int dim>
  void
  BodyParts<dim>::find_hinges(const Triangulation<dim> &triangulation)
  {
    std::map<unsigned int, Hinge> by_vertex;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
      {
        Hinge &hinge   = by_vertex[cell->vertex_index(v)];
        hinge.position = cell->vertex(v);
        hinge.parts.insert(part_of_cell[cell->index()]);
      }
    for (const auto &[vertex, hinge] : by_vertex)
      if (hinge.parts.size() > 1)
        all_hinges.push_back(hinge);
  }



  template <int dim>
  std::vector<unsigned int>
  BodyParts<dim>::groups(
    const std::vector<std::array<unsigned int, 2>> &joined) const
  {
    std::vector<unsigned int> root(n);
    for (unsigned int part = 0; part < n; ++part)
      root[part] = part;
    const auto root_of = [&root](unsigned int part) {
      while (root[part] != part)
        part = root[part] = root[root[part]];
      return part;
    };
    for (const Hinge &hinge : all_hinges)
      for (const unsigned int part : hinge.parts)
        root[root_of(part)] = root_of(*hinge.parts.begin());
    for (const auto &[one, other] : joined)
      root[root_of(one)] = root_of(other);
    std::map<unsigned int, unsigned int> number_of;
    std::vector<unsigned int>            result(n);
    for (unsigned int part = 0; part < n; ++part)
      result[part] =
        number_of.emplace(root_of(part), number_of.size()).first->second;
    return result;
  }



  template class BodyParts<2>;
  template class BodyParts<3>;
} // namespace MixedCracks
