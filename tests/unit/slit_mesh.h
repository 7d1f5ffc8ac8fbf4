// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_tests_unit_slit_mesh_h
#define mixed_cracks_tests_unit_slit_mesh_h

#include <deal.II/grid/tria.h>

#include <functional>
#include <map>
#include <vector>

namespace MixedCracks
{
  namespace Testing
  {
    /// Double the vertices on a slit, which is plane and normal to y: cells
    /// above it, y > @p height, get the new ones.
    template <int dim>
    void
    open_slit(const double                                           height,
              const std::function<bool(const dealii::Point<dim> &)> &is_on_slit,
              std::vector<dealii::Point<dim>>                       &vertices,
              std::vector<dealii::CellData<dim>>                    &cells)
    {
      std::map<unsigned int, unsigned int> doubled;
      for (unsigned int v = 0, n = vertices.size(); v < n; ++v)
        if (is_on_slit(vertices[v]))
        {
          doubled[v] = vertices.size();
          vertices.push_back(vertices[v]);
        }
      // of an upright cell vertex 2 has the larger y
      for (auto &cell : cells)
        if (vertices[cell.vertices[2]][1] > height + 1e-9)
          for (unsigned int &vertex : cell.vertices)
            if (doubled.count(vertex) > 0)
              vertex = doubled[vertex];
    }
  } // namespace Testing
} // namespace MixedCracks

#endif
