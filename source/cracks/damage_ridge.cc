// SPDX-License-Identifier: GPL-2.0-or-later
// Marching cubes on the values s_i = (l g + e c) . n_i at the eight nodes of a
// cell, n_i the eigenvector of H_i (damage_ridge_field.cc) with the smallest
// eigenvalue, with the sign that agrees with that of the mean H in the cell.
// Where the edge between two nodes is cut depends on |s| at its ends alone, so
// that the triangles of neighbouring cells meet, whatever signs they chose.
//
// e c, with e = 1e-7 and a vector c that is normal to nothing in particular:
// a crack along a row of nodes has g . n = 0 there but for rounding, and it
// would be a matter of chance which of the cells beside it have the sheet. It
// is moved by 1e-7 l.
//
// Cells are cut on the unit cell by GridTools::MarchingCubeAlgorithm, which
// needs no values in common with other cells for that.

#include <cracks/damage_ridge.h>
#include <cracks/damage_ridge_field.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <map>
#include <set>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    constexpr double ridge_shift = 1e-7;
    // of length 1
    const Tensor<1, 3> shift_direction({0.61234, 0.57713, 0.54032});
    // In 1/l^2: what is less curved across is no ridge. The smoothed profile of
    // a crack has 2 to 3, broken three nodes wide 1; |phi'|/r ahead of a front,
    // 0.7 where phi is 0.5.
    constexpr double least_curvature = 0.1;
    // on the unit cell: as near as that is on an edge
    constexpr double on_edge = 1e-3;

    // cell (4), number in it, corners (9), phase field (3), boundaries (3)
    using TriangleNumbers = std::array<double, 20>;
    using CornerIds       = std::set<int>;



    // The smallest eigenvalue and its vector.
    std::pair<double, Tensor<1, 3>>
    across(const SymmetricTensor<2, 3> &hessian)
    {
      const auto pairs =
        eigenvectors(hessian, SymmetricTensorEigenvectorMethod::jacobi);
      return pairs[2]; // the largest comes first
    }



    // The unit cell, cut where eight values pass 0.
    class UnitCell
    {
    public:
      UnitCell()
        : element(1)
        , dofs(mesh)
        , values(8)
        , cut(StaticMappingQ1<3>::mapping, element)
      {
        GridGenerator::hyper_cube(mesh);
        dofs.distribute_dofs(element);
      }

      /// Three corners for each triangle.
      std::vector<Point<3>>
      triangles(const std::array<double, 8> &at_vertices)
      {
        const auto cell = dofs.begin_active();
        for (unsigned int v = 0; v < 8; ++v)
          values(cell->vertex_dof_index(v, 0)) = at_vertices[v];
        std::vector<Point<3>>    corners, result;
        std::vector<CellData<2>> faces;
        cut.process_cell(cell, values, 0., corners, faces);
        for (const CellData<2> &face : faces)
          for (const unsigned int corner : face.vertices)
            result.push_back(corners[corner]);
        return result;
      }

    private:
      Triangulation<3>                                    mesh;
      FE_Q<3>                                             element;
      DoFHandler<3>                                       dofs;
      Vector<double>                                      values;
      GridTools::MarchingCubeAlgorithm<3, Vector<double>> cut;
    };



    // Ids of the boundaries that edges of the mesh lie on, by their index. The
    // tip of a slit has that of its faces, in the cells ahead of it, too.
    std::map<int, CornerIds>
    boundaries_of_edges(const RidgeField &field)
    {
      std::map<int, CornerIds> ids;
      for (const auto &cell : field.cells)
        for (const unsigned int f : cell.cell->face_indices())
          if (const auto face = cell.cell->face(f); face->at_boundary())
            for (unsigned int e = 0; e < face->n_lines(); ++e)
              ids[face->line(e)->index()].insert(
                static_cast<int>(face->boundary_id()));
      return ids;
    }



    // What makes triangles of the owned cells.
    class Cutter
    {
    public:
      Cutter(const RidgeField            &field,
             const LinearAlgebra::Vector &phase_field,
             const double                 length_scale)
        : field(field)
        , phase_field(phase_field)
        , length_scale(length_scale)
        , ids_of_edges(boundaries_of_edges(field))
      {}

      void
      add(const RidgeField::Cell &cell, std::vector<TriangleNumbers> &all)
      {
        std::array<double, 8> values;
        if (!signed_values(cell, values))
          return;
        const std::vector<Point<3>> corners = unit_cell.triangles(values);
        for (unsigned int i = 0; i + 2 < corners.size(); i += 3)
          all.push_back(numbers_of(cell, &corners[i], i / 3));
      }

    private:
      bool
      signed_values(const RidgeField::Cell &cell,
                    std::array<double, 8>  &values) const
      {
        SymmetricTensor<2, 3> mean;
        for (const unsigned int node : cell.nodes)
          mean += field.hessian(node) / 8.;
        const auto [curvature, normal] = across(mean);
        if (!(curvature * length_scale * length_scale < -least_curvature))
          return false;
        double least = 0., largest = 0.;
        for (unsigned int v = 0; v < 8; ++v)
        {
          const Tensor<1, 3> own = across(field.hessian(cell.nodes[v])).second;
          values[v] = (length_scale * field.gradient(cell.nodes[v]) +
                       ridge_shift * shift_direction) *
                      own * (own * normal < 0. ? -1. : 1.);
          least   = std::min(least, values[v]);
          largest = std::max(largest, values[v]);
        }
        return least < 0. && largest > 0.;
      }

      CornerIds
      ids_at(const RidgeField::Cell &cell, const Point<3> &corner) const
      {
        CornerIds ids;
        for (unsigned int e = 0; e < GeometryInfo<3>::lines_per_cell; ++e)
        {
          const auto found = ids_of_edges.find(cell.cell->line(e)->index());
          if (found == ids_of_edges.end())
            continue;
          const Point<3> begin = GeometryInfo<3>::unit_cell_vertex(
                           GeometryInfo<3>::line_to_cell_vertices(e, 0)),
                         end = GeometryInfo<3>::unit_cell_vertex(
                           GeometryInfo<3>::line_to_cell_vertices(e, 1));
          const double s = std::clamp((corner - begin) * (end - begin), 0., 1.);
          if (corner.distance(begin + s * (end - begin)) < on_edge)
            ids.insert(found->second.begin(), found->second.end());
        }
        return ids;
      }

      TriangleNumbers
      numbers_of(const RidgeField::Cell &cell,
                 const Point<3>         *corners,
                 const unsigned int      number) const
      {
        TriangleNumbers          numbers;
        std::array<CornerIds, 3> ids;
        const auto               id = cell.cell->id().template to_binary<3>();
        std::copy(id.begin(), id.end(), numbers.begin());
        numbers[4] = number;
        for (unsigned int i = 0; i < 3; ++i)
        {
          Point<3> place;
          double   value = 0.;
          for (unsigned int v = 0; v < 8; ++v)
          {
            const double shape =
              GeometryInfo<3>::d_linear_shape_function(corners[i], v);
            place += shape * cell.cell->vertex(v);
            value += shape * phase_field(cell.cell->vertex_dof_index(v, 0));
          }
          for (unsigned int d = 0; d < 3; ++d)
            numbers[5 + 3 * i + d] = place[d];
          numbers[14 + i] = value;
          ids[i]          = ids_at(cell, corners[i]);
        }
        for (unsigned int i = 0; i < 3; ++i)
        {
          numbers[17 + i] = RidgeTriangle::inside;
          for (const int one : ids[i])
            if (ids[(i + 1) % 3].count(one) > 0)
            {
              numbers[17 + i] = one;
              break;
            }
        }
        return numbers;
      }

      const RidgeField            &field;
      const LinearAlgebra::Vector &phase_field;
      const double                 length_scale;
      std::map<int, CornerIds>     ids_of_edges;
      UnitCell                     unit_cell;
    };



    RidgeTriangle
    triangle_of(const TriangleNumbers &numbers)
    {
      RidgeTriangle triangle;
      for (unsigned int i = 0; i < 3; ++i)
      {
        for (unsigned int d = 0; d < 3; ++d)
          triangle.corners[i][d] = numbers[5 + 3 * i + d];
        triangle.phase_field[i] = numbers[14 + i];
        triangle.boundary[i]    = static_cast<int>(numbers[17 + i]);
      }
      return triangle;
    }
  } // namespace



  DamageRidge
  damage_ridge(const Fields<3>             &fields,
               const LinearAlgebra::Vector &phase_field,
               const double                 length_scale)
  {
    RidgeField  field(fields, phase_field, length_scale);
    DamageRidge ridge;
    ridge.cell_size = field.cell_size;
    if (field.cell_size == 0.)
      return ridge;
    field.differentiate();
    std::vector<TriangleNumbers> own, all;
    Cutter                       cutter(field, phase_field, length_scale);
    for (const RidgeField::Cell &cell : field.cells)
      if (cell.cell->is_locally_owned())
        cutter.add(cell, own);
    for (const auto &part : Utilities::MPI::gather(fields.communicator(), own))
      all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    for (const TriangleNumbers &numbers : all)
      ridge.triangles.push_back(triangle_of(numbers));
    return ridge;
  }
} // namespace MixedCracks
