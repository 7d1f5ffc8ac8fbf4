// SPDX-License-Identifier: GPL-2.0-or-later
// Is a tangent isotropic? Then it is two numbers,
//
//   C_ijkl = a (d_ik d_jl + d_il d_jk)/2 + b d_ij d_kl,
//   a = 2 C_0101,  b = C_0011,     d the Kronecker symbol,
//
// as it is in intact material (2 mu, lambda) and where the split is that of
// Amor, however broken: g and the volumetric part change a and b only. Splits
// by principal strains have other tangents where they split.

#include <model/elastic_response.h>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // relative to the norm: of rounding
    constexpr double negligible = 1e-13;
  } // namespace



  template <int dim>
  double
  tangent_entry(const SymmetricTensor<4, dim> &tangent,
                const unsigned int             row,
                const unsigned int             column)
  {
    const TableIndices<2>
      i = SymmetricTensor<2, dim>::unrolled_to_component_indices(row),
      j = SymmetricTensor<2, dim>::unrolled_to_component_indices(column);
    return tangent[i[0]][i[1]][j[0]][j[1]];
  }



  template <int dim>
  std::optional<IsotropicTangent>
  isotropic_tangent(const SymmetricTensor<4, dim> &tangent)
  {
    static const SymmetricTensor<4, dim> identity = identity_tensor<dim>();
    static const SymmetricTensor<4, dim> volume =
      outer_product(unit_symmetric_tensor<dim>(), unit_symmetric_tensor<dim>());
    const IsotropicTangent result{2. * tangent[0][1][0][1],
                                  tangent[0][0][1][1]};
    const double           excess =
      (tangent - result.identity * identity - result.volume * volume).norm();
    if (excess <= negligible * tangent.norm())
      return result;
    return std::nullopt;
  }



#define INSTANTIATE(dim)                                          \
  template double tangent_entry(                                  \
    const SymmetricTensor<4, dim> &, unsigned int, unsigned int); \
  template std::optional<IsotropicTangent> isotropic_tangent(     \
    const SymmetricTensor<4, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
