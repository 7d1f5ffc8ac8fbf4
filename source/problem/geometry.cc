// SPDX-License-Identifier: GPL-2.0-or-later
#include <deal.II/base/patterns.h>

#include <input/dimension.h>

#include <problem/geometries/l_shape.h>
#include <problem/geometries/mesh_file.h>
#include <problem/geometries/punctured_strip.h>
#include <problem/geometries/quadrilateral.h>
#include <problem/geometries/rectangle.h>
#include <problem/geometries/slit_square.h>
#include <problem/geometry.h>

#include <algorithm>
#include <cctype>

namespace MixedCracks
{
  template <>
  const Registry<Geometry<2>> &
  all_geometries<2>()
  {
    static const Registry<Geometry<2>> geometries(
      "geometry",
      {{"punctured strip",
        "a strip with a circular hole and a sharp notch, either optional",
        [] { return std::make_unique<PuncturedStrip<2>>(); }},
       {"slit square",
        "a square with a sharp slit from its left edge",
        [] { return std::make_unique<SlitSquare<2>>(); }},
       {"rectangle",
        "a box between two corners",
        [] { return std::make_unique<Rectangle<2>>(); }},
       {"L-shape",
        "a square without its lower right quadrant",
        [] { return std::make_unique<LShape<2>>(); }},
       {"quadrilateral",
        "four corners joined by straight sides",
        [] { return std::make_unique<Quadrilateral<2>>(); }},
       {"mesh file",
        "a mesh of quadrilaterals from a Gmsh, Abaqus or UCD file",
        [] { return std::make_unique<MeshFile<2>>(); }}});
    return geometries;
  }



  template <>
  const Registry<Geometry<3>> &
  all_geometries<3>()
  {
    static const Registry<Geometry<3>> geometries(
      "geometry",
      {{"punctured strip",
        "the strip of 2-d, of the thickness of the material",
        [] { return std::make_unique<PuncturedStrip<3>>(); }},
       {"slit cube",
        "a cube with a sharp plane slit from its left face",
        [] { return std::make_unique<SlitSquare<3>>(); }},
       {"box",
        "a box between two corners",
        [] { return std::make_unique<Rectangle<3>>(); }},
       {"L-shape",
        "the L-shape of 2-d, of the thickness of the material",
        [] { return std::make_unique<LShape<3>>(); }},
       {"quadrilateral",
        "the quadrilateral of 2-d, of the thickness of the material",
        [] { return std::make_unique<Quadrilateral<3>>(); }},
       {"mesh file", "a mesh of hexahedra from a Gmsh, Abaqus or UCD file", [] {
          return std::make_unique<MeshFile<3>>();
        }}});
    return geometries;
  }



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
  }



  template <int dim>
  const Geometry<dim> &
  GeometryParameters<dim>::chosen() const
  {
    return *geometries.at(name);
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
