// SPDX-License-Identifier: GPL-2.0-or-later
// Which lanes this processor has is asked when the program runs. AVX2 with FMA:
// 4 doubles. AVX-512 was no faster (doc/records/solvers.md).

#include <assembly/cell_products.h>

#include <base/lanes.h>

namespace MixedCracks
{
  using namespace dealii;

  template <int dim>
  std::unique_ptr<CellProducts<dim>>
  make_cell_products(const Mapping<dim>              &mapping,
                     const DoFHandler<dim>           &handler,
                     const AffineConstraints<double> &constraints)
  {
#ifdef MIXED_CRACKS_WITH_AVX2
    if (has_avx2())
      return make_cell_products_with_lanes<dim, 4>(
        mapping, handler, constraints);
#endif
    return make_cell_products_with_lanes<dim, 0>(mapping, handler, constraints);
  }



#define INSTANTIATE(dim)                                          \
  template std::unique_ptr<CellProducts<dim>> make_cell_products( \
    const Mapping<dim> &,                                         \
    const DoFHandler<dim> &,                                      \
    const AffineConstraints<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
