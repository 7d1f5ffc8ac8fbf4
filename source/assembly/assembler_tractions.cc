// SPDX-License-Identifier: GPL-2.0-or-later
// Tractions on the boundary, at the quadrature points of its faces,
//
//   t = P n,   dA = w |det J| |J^-T n_ref|,   n = J^-T n_ref / |J^-T n_ref|,
//
// with the stress of the kernel, sigma at small strain, at finite strain that
// of Piola, per undeformed area. A polynomial of degree k - 1, as the stress of
// shape functions of degree k is along them, is taken exactly by k points for
// each direction of the face, and there it is most accurate.

#include <assembly/assembler.h>

#include <base/collective.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Quadrature<dim>
    quadrature_on_face(const unsigned int face, const unsigned int degree)
    {
      const QGauss<dim - 1>   on_face(degree);
      std::vector<Point<dim>> points(on_face.size());
      QProjector<dim>::project_to_face(
        ReferenceCells::get_hypercube<dim>(), on_face, face, points);
      return {points, on_face.get_weights()};
    }



    // What is needed on the face of one number, of any cell.
    template <int dim>
    class FaceKernel
    {
    public:
      FaceKernel(const Fields<dim>            &fields,
                 const Material<dim>          &material,
                 const ConstantsFunction<dim> &constants_at,
                 const unsigned int            face)
        : fields(fields)
        , constants_at(constants_at)
        , reference_normal(GeometryInfo<dim>::unit_normal_vector[face])
        , quadrature(
            quadrature_on_face<dim>(face, fields.elastic.get_fe().degree))
        , geometry(fields.mapping, quadrature)
        , elastic(fields.elastic.get_fe(),
                  quadrature,
                  material,
                  fields.layout.mixed)
        , phase_field(fields.phase_field.get_fe(), quadrature, material)
        , constants(quadrature.size(),
                    constants_at ? PointConstants{}
                                 : material.uniform_constants())
      {}

      // Throws InputError, perhaps on one rank alone.
      void
      add(const typename DoFHandler<dim>::active_cell_iterator &cell,
          const LinearAlgebra::Vector                          &solution,
          const LinearAlgebra::Vector                          &lagged,
          std::vector<TractionPoint<dim>>                      &result)
      {
        const CellGeometry<dim> here = geometry(cell);
        set_state(cell, here, solution, lagged);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Tensor<1, dim> normal =
            reference_normal * here.inverse_jacobians[q];
          TractionPoint<dim> point;
          point.position = fields.mapping.transform_unit_to_real_cell(
            cell, quadrature.point(q));
          point.normal   = normal / normal.norm();
          point.area     = here.weights[q] * normal.norm();
          point.traction = elastic.point_responses()[q].stress * point.normal;
          result.push_back(point);
        }
      }

    private:
      void
      set_state(const typename DoFHandler<dim>::active_cell_iterator &cell,
                const CellGeometry<dim>                              &here,
                const LinearAlgebra::Vector                          &solution,
                const LinearAlgebra::Vector                          &lagged)
      {
        Vector<double> local(fields.elastic.get_fe().n_dofs_per_cell());
        cell->get_dof_values(solution, local);
        Vector<double> local_lagged(
          fields.phase_field.get_fe().n_dofs_per_cell());
        typename DoFHandler<dim>::active_cell_iterator(
          &cell->get_triangulation(),
          cell->level(),
          cell->index(),
          &fields.phase_field)
          ->get_dof_values(lagged, local_lagged);
        std::vector<double> values(quadrature.size());
        phase_field.interpolate(local_lagged, values);
        if (constants_at)
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            constants[q] =
              constants_at(fields.mapping.transform_unit_to_real_cell(
                             cell, quadrature.point(q)),
                           cell->material_id());
        elastic.reinit(here, CellConstants(constants.data()));
        elastic.set_state(local, values, ElasticEvaluation::tangents);
      }

      const Fields<dim>            &fields;
      const ConstantsFunction<dim> &constants_at;
      const Tensor<1, dim>          reference_normal;
      const Quadrature<dim>         quadrature;
      GeometryEvaluator<dim>        geometry;
      ElasticKernel<dim>            elastic;
      PhaseFieldKernel<dim>         phase_field;
      std::vector<PointConstants>   constants;
    };
  } // namespace



  template <int dim>
  std::vector<TractionPoint<dim>>
  Assembler<dim>::tractions(const BoundaryIds &boundary,
                            const Vector      &elastic,
                            const Vector      &lagged_phase_field) const
  {
    std::vector<TractionPoint<dim>> result;
    std::array<std::unique_ptr<FaceKernel<dim>>,
               GeometryInfo<dim>::faces_per_cell>
      kernels;
    together(fields.communicator(), [&]() {
      for (const auto &cell : fields.elastic.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                boundary.contains(cell->face(f)->boundary_id()))
            {
              if (!kernels[f])
                kernels[f] = std::make_unique<FaceKernel<dim>>(
                  fields, material, constants_at, f);
              kernels[f]->add(cell, elastic, lagged_phase_field, result);
            }
    });
    return result;
  }



#define INSTANTIATE(dim)                                              \
  template std::vector<TractionPoint<dim>> Assembler<dim>::tractions( \
    const BoundaryIds &, const Vector &, const Vector &) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
