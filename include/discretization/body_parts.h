// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_discretization_body_parts_h
#define mixed_cracks_discretization_body_parts_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <map>
#include <set>
#include <vector>

namespace MixedCracks
{
  /// The parts of a coarse mesh that share no face, numbered from 0, and the
  /// vertices at which they are hinged to each other. The same on every rank.
  template <int dim>
  class BodyParts
  {
  public:
    explicit BodyParts(const dealii::Triangulation<dim> &triangulation);

    unsigned int
    n_parts() const
    {
      return n;
    }

    /// The part of a cell of the coarse mesh, by its index.
    unsigned int
    of_cell(const unsigned int index) const
    {
      return part_of_cell[index];
    }

    /// Of the box around a part; mm.
    dealii::Point<dim>
    middle(const unsigned int part) const
    {
      return boxes[part].center();
    }

    /// A vertex that several parts share.
    struct Hinge
    {
      dealii::Point<dim>     position; ///< mm
      std::set<unsigned int> parts;
    };

    const std::vector<Hinge> &
    hinges() const
    {
      return all_hinges;
    }

    /// By part, the number of its group: parts that hang together by hinges,
    /// directly or by way of others, are in one; and so are those that are
    /// @p joined otherwise.
    std::vector<unsigned int>
    groups(const std::vector<std::array<unsigned int, 2>> &joined = {}) const;

  private:
    void flood(const typename dealii::Triangulation<dim>::cell_iterator &seed);

    void find_hinges(const dealii::Triangulation<dim> &triangulation);

    unsigned int                          n = 0;
    std::vector<unsigned int>             part_of_cell;
    std::vector<dealii::BoundingBox<dim>> boxes;
    std::vector<Hinge>                    all_hinges;
  };
} // namespace MixedCracks

#endif
