// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_assembly_isotropic_cell_h
#define mixed_cracks_assembly_isotropic_cell_h

#include <assembly/cell_geometry.h>

#include <deal.II/fe/fe_q.h>

#include <model/elastic_response.h>

#include <vector>

namespace MixedCracks
{
  /// The responses of one cell whose tangents are all isotropic, C = a 1 + b I
  /// (x) I, one entry per quadrature point; names as in ElasticResponse.
  struct IsotropicCell
  {
    std::vector<double> identity; ///< a, MPa
    std::vector<double> volume;   ///< b, MPa
    std::vector<double> stress_by_pressure;
    std::vector<double> constraint_by_trace;
    std::vector<double> constraint_by_pressure; ///< 1/MPa

    void resize(unsigned int n_points);

    /// Take those of a cell; false if they are not isotropic.
    template <int dim>
    bool read(const std::vector<ElasticResponse<dim>> &responses);
  };

  /// The stiffness of displacements in such a cell, all components of a node
  /// with the same shape functions, linear or quadratic.
  template <int dim>
  class IsotropicStiffness
  {
  public:
    IsotropicStiffness(const dealii::FE_Q<dim>       &element,
                       const dealii::Quadrature<dim> &quadrature);

    /// For entry().
    void assemble(const CellGeometry<dim> &geometry, const IsotropicCell &cell);

    unsigned int
    n_shapes() const
    {
      return n;
    }

    /// Between component @p d of shape @p a and @p e of @p b; N/mm, in the
    /// plane N/mm^2.
    double
    entry(const unsigned int a,
          const unsigned int d,
          const unsigned int b,
          const unsigned int e) const
    {
      return entries[((b * dim + e) * dim + d) * n_padded + a];
    }

  private:
    const unsigned int n, n_padded; // to whole registers
    /// of each point and direction all shapes, on the reference cell and on
    /// this one
    std::vector<double> reference_gradients, gradients;
    std::vector<double> entries;
  };
} // namespace MixedCracks

#endif
