// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometry_h
#define mixed_cracks_problem_geometry_h

#include <core/registry.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A straight piece of a crack, in mm.
  template <int dim>
  struct Segment
  {
    dealii::Point<dim> begin;
    dealii::Point<dim> end;
  };

  /// A domain by name: its own subsection of the .prm, its checks, and its
  /// coarse mesh.
  template <int dim>
  class Geometry
  {
  public:
    virtual ~Geometry() = default;

    /// Add the entries of this geometry; the caller has entered its
    /// subsection.
    virtual void add_parameters(dealii::ParameterHandler &prm) = 0;

    /// Throws InputError, with the numbers, when the values cannot be built.
    virtual void check() const = 0;

    /// Names and ids of the boundary parts, known before the mesh is built.
    virtual std::map<std::string, dealii::types::boundary_id>
    boundary_ids() const = 0;

    /// The box around the domain; mm. None when only the mesh can tell.
    virtual std::optional<dealii::BoundingBox<dim>> extent() const = 0;

    /// Build the coarse mesh with boundary ids, manifold ids and manifolds
    /// set. Called by every rank alike. Throws FileError when a mesh file
    /// cannot be read.
    virtual void create(dealii::Triangulation<dim> &triangulation) const = 0;

    /// Points of interest by name; mm.
    virtual std::map<std::string, dealii::Point<dim>>
    named_points() const
    {
      return {};
    }

    /// The names of boundaries and points.
    std::vector<std::string> names() const;

    /// Slits of the mesh (doubled nodes): the phase field is 0 on them.
    virtual std::vector<Segment<dim>>
    slits() const
    {
      return {};
    }
  };

  /// Geometries by name; the name in lower case but for its first letter is
  /// that of its subsection ("punctured strip": "Punctured strip").
  template <int dim>
  const Registry<Geometry<dim>> &all_geometries();

  /// Subsection "Geometry": the name, and a subsection for each geometry.
  template <int dim>
  class GeometryParameters
  {
  public:
    GeometryParameters();

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// Checks the chosen geometry only.
    void check() const;

    /// Its name in the .prm.
    const std::string &
    name_of_chosen() const
    {
      return name;
    }

    /// The chosen one.
    const Geometry<dim> &chosen() const;

  private:
    std::string                                           name;
    std::map<std::string, std::unique_ptr<Geometry<dim>>> geometries;
  };
} // namespace MixedCracks

#endif
