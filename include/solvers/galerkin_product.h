// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_solvers_galerkin_product_h
#define mixed_cracks_solvers_galerkin_product_h

struct ML_Struct;
class Epetra_CrsMatrix;

namespace MixedCracks
{
  /// Sets the matrix of level 1 of @p hierarchy to P^T A P, as ML_rap() does,
  /// by blocks: @p n_components (2 or 3) rows per node, @p n_modes (3 or 6)
  /// columns per aggregate. @p matrix: A, of level 0; P and its transpose are
  /// those of the hierarchy. Collective.
  void set_galerkin_product(ML_Struct              &hierarchy,
                            const Epetra_CrsMatrix &matrix,
                            unsigned int            n_components,
                            unsigned int            n_modes);
} // namespace MixedCracks

#endif
