// SPDX-License-Identifier: GPL-2.0-or-later
// The list of geometries and the subsection "Geometry". Whatever the dimension
// of a run, its .prm may hold the subsections of both: those of the other
// dimension are made too ('elsewhere'), for their entries only, so that one
// manual holds for both. Their names are refused in check(), not by the pattern
// of the entry: the message can then say in which dimension they exist.
//
// A new geometry is a PlaneFigure (see geometries/l_shape.cc), or a Geometry
// where space is not the plane times an interval, and one entry in the list
// below.

#include <deal.II/base/patterns.h>

#include <input/dimension.h>

#include <problem/geometries/boundary_regions.h>
#include <problem/geometries/l_shape.h>
#include <problem/geometries/mesh_file.h>
#include <problem/geometries/plane_geometry.h>
#include <problem/geometries/punctured_strip.h>
#include <problem/geometries/quadrilateral.h>
#include <problem/geometries/rectangle.h>
#include <problem/geometries/slit_square.h>
#include <problem/geometry.h>
#include <problem/periodic_entries.h>

#include <algorithm>
#include <cctype>
#include <type_traits>

namespace MixedCracks
{
  namespace
  {
    // A figure in the plane, in 3-d what it becomes there; the figures that
    // differ between the two are told the dimension.
    template <int dim, typename Figure>
    std::unique_ptr<Geometry<dim>>
    make_plane()
    {
      if constexpr (std::is_constructible_v<Figure, int>)
        return std::make_unique<PlaneGeometry<dim>>(
          std::make_unique<Figure>(dim));
      else
        return std::make_unique<PlaneGeometry<dim>>(std::make_unique<Figure>());
    }



    template <int dim, template <int> class Body>
    std::unique_ptr<Geometry<dim>>
    make_body()
    {
      return std::make_unique<Body<dim>>();
    }



    // All geometries, once for both dimensions: name and description in 2-d, in
    // 3-d, and how it is made.
    template <int dim>
    std::vector<typename Registry<Geometry<dim>>::Entry>
    entries()
    {
      const auto entry = [](const char *const name_2d,
                            const char *const description_2d,
                            const char *const name_3d,
                            const char *const description_3d,
                            std::unique_ptr<Geometry<dim>> (*make)()) {
        return typename Registry<Geometry<dim>>::Entry{
          dim == 2 ? name_2d : name_3d,
          dim == 2 ? description_2d : description_3d,
          make};
      };
      return {
        entry("punctured strip",
              "a strip with a circular hole and a sharp notch, either "
              "optional",
              "punctured strip",
              "the strip of 2-d, of the thickness of the material",
              make_plane<dim, PuncturedStrip>),
        entry("slit square",
              "a square with a sharp slit from its left edge",
              "slit cube",
              "a cube with a sharp plane slit from its left face",
              make_plane<dim, SlitSquare>),
        entry("rectangle",
              "a box between two corners",
              "box",
              "a box between two corners",
              make_body<dim, Rectangle>),
        entry("L-shape",
              "a square without its lower right quadrant",
              "L-shape",
              "the L-shape of 2-d, of the thickness of the material",
              make_plane<dim, LShape>),
        entry("quadrilateral",
              "four corners joined by straight sides",
              "quadrilateral",
              "the quadrilateral of 2-d, of the thickness of the material",
              make_plane<dim, Quadrilateral>),
        entry("mesh file",
              "a mesh of quadrilaterals from a Gmsh, Abaqus or UCD file",
              "mesh file",
              "a mesh of hexahedra from a Gmsh, Abaqus or UCD file",
              make_body<dim, MeshFile>)};
    }
  } // namespace



  template <int dim>
  const Registry<Geometry<dim>> &
  all_geometries()
  {
    static const Registry<Geometry<dim>> geometries("geometry", entries<dim>());
    return geometries;
  }

  template const Registry<Geometry<2>> &all_geometries<2>();
  template const Registry<Geometry<3>> &all_geometries<3>();



  namespace
  {
    std::string
    subsection_name(std::string name)
    {
      name[0] =
        static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      return name;
    }



    // those of 2-d, then the others
    std::vector<std::string>
    names_of_both_dimensions()
    {
      std::vector<std::string> names = all_geometries<2>().names();
      for (const std::string &name : all_geometries<3>().names())
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
      return names;
    }
  } // namespace



  template <int dim>
  GeometryParameters<dim>::GeometryParameters()
    : name(all_geometries<dim>().names().front())
  {
    for (const std::string &each : all_geometries<dim>().names())
      geometries[each] = all_geometries<dim>().make(each);
    for (const std::string &each : all_geometries<other_dim>().names())
      if (geometries.count(each) == 0)
        elsewhere[each] = all_geometries<other_dim>().make(each);
  }



  template <int dim>
  void
  GeometryParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    const std::vector<std::string> names = names_of_both_dimensions();
    prm.enter_subsection("Geometry");
    add_dimension(prm, dimension);
    prm.add_parameter(
      "Name",
      name,
      "The domain. In 2-d: " + all_geometries<2>().documentation() +
        " In 3-d: " + all_geometries<3>().documentation() +
        " Only the subsection of the chosen one is used.",
      dealii::Patterns::Selection(join_names(names, "|")));
    prm.add_parameter(
      "Boundary regions",
      regions,
      "Names for parts of the boundary by their position, for every geometry "
      "and every mesh from a file: 'name : condition ; ...', as in 'grip : x > "
      "90 && y > 10 ; foot : abs(y) < 1e-6'. The condition is an expression in "
      "x, y, z (mm; comparisons, && and ||), taken at the centre of each face "
      "of the coarse mesh, which is the mean of its corners, before Mesh/Global "
      "refinements: a part cannot be smaller than one of these faces, and a "
      "face that lies on both sides of a limit goes by its centre. Finer faces "
      "inherit. A face leaves the side that it was part of, and of several "
      "regions it belongs to the one that is listed last. Names must be new, "
      "and are used as those of sides. --check, which builds no large mesh, "
      "tries the conditions on larger faces.",
      dealii::Patterns::Anything());
    prm.add_parameter(
      "Periodic sides",
      periodic_sides,
      "Pairs of sides that are images of each other, 'boundary : boundary ; "
      "...', as in 'left : right ; bottom : top': the body is one cell of a "
      "pattern that repeats itself. Both are flat, and their faces differ by "
      "one translation L, which the program finds. Pressure and phase field are "
      "equal on them, a crack that leaves through one enters through the other; "
      "displacements differ by u+ - u- = E L, see Boundary conditions/Mean "
      "strain. What nothing else holds of the body's translations is held at "
      "one vertex.",
      dealii::Patterns::Anything());
    points.add_parameters(prm);
    for (const std::string &each : names)
    {
      prm.enter_subsection(subsection_name(each));
      if (geometries.count(each) > 0)
        geometries.at(each)->add_parameters(prm);
      else
        elsewhere.at(each)->add_parameters(prm);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  template <int dim>
  void
  GeometryParameters<dim>::take_thickness_from(const double &thickness)
  {
    for (const auto &each : geometries)
      each.second->take_thickness_from(thickness);
  }



  template <int dim>
  void
  GeometryParameters<dim>::check() const
  {
    if (elsewhere.count(name) > 0)
      throw InputError(
        "Geometry/Name: found '" + name + "', which there is in " +
        std::to_string(other_dim) +
        "-d only, with Geometry/Dimension = " + std::to_string(dim) +
        "; allowed are " + join_names(all_geometries<dim>().names()) + ".");
    chosen().check();
    points.check();
  }



  template <int dim>
  const Geometry<dim> &
  GeometryParameters<dim>::chosen() const
  {
    const Geometry<dim> &geometry = *geometries.at(name);
    if (regions.empty())
      return geometry;
    const std::string key = name + " : " + regions;
    if (!with_regions || key != made_with_regions)
    {
      with_regions = std::make_unique<GeometryWithRegions<dim>>(
        geometry,
        parse_named_conditions<dim>(regions, "Geometry/Boundary regions"));
      made_with_regions = key;
    }
    return *with_regions;
  }



  template <int dim>
  std::vector<PeriodicPair>
  GeometryParameters<dim>::periodic_pairs() const
  {
    return read_periodic_pairs(
      periodic_sides, chosen().boundary_ids(), [this]() {
        return chosen().hint_about_boundaries();
      });
  }



  template <int dim>
  std::map<dealii::types::boundary_id, std::string>
  Geometry<dim>::names_of_ids() const
  {
    std::map<dealii::types::boundary_id, std::string> result;
    const NamedBoundaries boundaries = boundary_ids();
    for (const auto &[name, ids] : boundaries)
      for (const auto id : ids)
        if (const auto [known, is_new] = result.emplace(id, name);
            !is_new && boundaries.at(known->second).size() < ids.size())
          known->second = name;
    return result;
  }



  template <int dim>
  std::vector<std::string>
  Geometry<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &boundary : boundary_ids())
      result.push_back(boundary.first);
    for (const auto &place : named_places())
      result.push_back(place.first);
    return result;
  }



  template class Geometry<2>;
  template class Geometry<3>;
  template class GeometryParameters<2>;
  template class GeometryParameters<3>;
} // namespace MixedCracks
