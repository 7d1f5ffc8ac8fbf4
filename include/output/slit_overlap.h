// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_slit_overlap_h
#define mixed_cracks_output_slit_overlap_h

#include <discretization/fields.h>
#include <discretization/slit_faces.h>

#include <map>
#include <utility>
#include <vector>

namespace MixedCracks
{
  /// Whether the faces of slits pass through each other: there is no contact
  /// between them.
  template <int dim>
  class SlitOverlap
  {
  public:
    struct Place
    {
      double             depth = 0.; ///< mm; 0: nowhere
      dealii::Point<dim> position;   ///< of the undeformed body, mm
    };

    explicit SlitOverlap(const Fields<dim> &fields)
      : fields(fields)
    {}

    /// When the coarse mesh is there, and may be called again.
    void reinit();

    const std::vector<SlitFace<dim>> &
    slits() const
    {
      return faces;
    }

    /// Where the vertices of one side lie deepest in the other one, across the
    /// undeformed slit; vertices with no partner (hanging ones) are not asked.
    /// Depths below a hundredth of the largest jump of the displacement are
    /// left out. @p elastic has ghosts. The same on every rank. Collective.
    Place deepest(const LinearAlgebra::Vector &elastic) const;

  private:
    // position, displacement (dim numbers each), side, number of the slit face
    std::vector<double>
    displacements_at_slits(const LinearAlgebra::Vector &elastic) const;

    const Fields<dim>         &fields;
    std::vector<SlitFace<dim>> faces;
    /// by coarse cell and face: number of the slit face, side
    std::map<std::pair<dealii::types::coarse_cell_id, unsigned int>,
             std::pair<unsigned int, unsigned int>>
      side_at;
  };
} // namespace MixedCracks

#endif
