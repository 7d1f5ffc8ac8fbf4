// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometry_h
#define mixed_cracks_problem_geometry_h

#include <base/flat_piece.h>
#include <base/registry.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <discretization/boundary_ids.h>
#include <discretization/periodic_sides.h>

#include <problem/point_sets.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A straight crack, in mm.
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
    virtual NamedBoundaries boundary_ids() const = 0;

    /// What each of these ids is called where there is one name for a face: of
    /// several names the one that stands for most ids.
    virtual std::map<dealii::types::boundary_id, std::string>
    names_of_ids() const;

    /// The box around the domain; mm. None when only the mesh can tell.
    virtual std::optional<dealii::BoundingBox<dim>> extent() const = 0;

    /// Build the coarse mesh with boundary ids, manifold ids and manifolds
    /// set. Called by every rank alike. Throws FileError when a mesh file
    /// cannot be read.
    virtual void create(dealii::Triangulation<dim> &triangulation) const = 0;

    /// After create(): what a user ought to know about how the mesh was made;
    /// words, or nothing.
    virtual std::string
    about_mesh() const
    {
      return "";
    }

    /// How many cells the coarse mesh has, about, told before it is built; none
    /// when only the mesh can tell.
    virtual std::optional<double>
    n_coarse_cells() const
    {
      return {};
    }

    /// The same domain with a coarse mesh of cells that are @p factor times as
    /// long, as far as the domain allows. Null where n_coarse_cells() is none.
    virtual std::unique_ptr<Geometry<dim>>
    coarser(const double /*factor*/) const
    {
      return nullptr;
    }

    /// More about the names of the boundary parts, for the message about one
    /// that is not there: sentences, or nothing.
    virtual std::string
    hint_about_boundaries() const
    {
      return "";
    }

    /// Places of interest by name, as the tip of a slit: points in 2-d, in 3-d
    /// the lines that they become; mm.
    virtual std::map<std::string, FlatPiece<dim>>
    named_places() const
    {
      return {};
    }

    /// The names of boundaries and places.
    std::vector<std::string> names() const;

    /// Slits of the mesh (doubled nodes): the phase field is 0 on them.
    virtual std::vector<FlatPiece<dim>>
    slits() const
    {
      return {};
    }

    /// Where the thickness of a plane figure in 3-d is read from, mm; 1 by
    /// default. The number must outlive the geometry.
    void
    take_thickness_from(const double &source)
    {
      thickness_source = &source;
    }

  protected:
    /// mm
    double
    thickness() const
    {
      return *thickness_source;
    }

  private:
    static constexpr double unit_thickness   = 1.;
    const double           *thickness_source = &unit_thickness;
  };

  /// Geometries of a dimension by name; the name in lower case but for its
  /// first letter is that of its subsection ("punctured strip": "Punctured
  /// strip").
  template <int dim>
  const Registry<Geometry<dim>> &all_geometries();

  /// Subsection "Geometry": the dimension, the name, and a subsection for each
  /// geometry, of both dimensions: the entries are the same in 2-d and in 3-d.
  template <int dim>
  class GeometryParameters
  {
  public:
    GeometryParameters();

    /// Enters the subsection itself.
    void add_parameters(dealii::ParameterHandler &prm);

    /// See Geometry::take_thickness_from().
    void take_thickness_from(const double &thickness);

    /// Checks the chosen geometry only, and what names parts of it by their
    /// position. Throws InputError when this dimension has none of that name.
    void check() const;

    /// Its name in the .prm.
    const std::string &
    name_of_chosen() const
    {
      return name;
    }

    /// The chosen one, with the names of "Boundary regions". Throws InputError
    /// when these cannot be read.
    const Geometry<dim> &chosen() const;

    /// "Periodic sides". Throws InputError when these cannot be read.
    std::vector<PeriodicPair> periodic_pairs() const;

    /// "Point sets".
    const PointSets<dim> &
    point_sets() const
    {
      return points;
    }

  private:
    static constexpr int other_dim = 5 - dim;

    std::string                                           dimension = "2";
    std::string                                           name;
    std::string                                           regions;
    std::string                                           periodic_sides;
    PointSets<dim>                                        points;
    std::map<std::string, std::unique_ptr<Geometry<dim>>> geometries;
    /// made when it is asked for, as entries are read after they are added
    mutable std::unique_ptr<Geometry<dim>> with_regions;
    mutable std::string                    made_with_regions;
    /// those that this dimension does not have, for their entries
    std::map<std::string, std::unique_ptr<Geometry<other_dim>>> elsewhere;
  };
} // namespace MixedCracks

#endif
