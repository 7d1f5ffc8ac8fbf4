// SPDX-License-Identifier: GPL-2.0-or-later
#include <problem/geometries/l_shape.h>
#include <problem/geometries/mesh_file.h>
#include <problem/geometries/punctured_strip.h>
#include <problem/geometries/rectangle.h>
#include <problem/geometries/slit_square.h>
#include <problem/geometry.h>

#include <deal.II/base/patterns.h>

#include <cctype>

namespace MixedCracks
{
  template <int dim>
  const Registry<Geometry<dim>> &
  all_geometries()
  {
    static const Registry<Geometry<dim>> geometries(
      "geometry",
      {{"punctured strip",
        "a strip with a circular hole and a sharp notch, either optional",
        [] { return std::make_unique<PuncturedStrip<dim>>(); }},
       {"slit square",
        "a square with a sharp slit from its left edge",
        [] { return std::make_unique<SlitSquare<dim>>(); }},
       {"rectangle",
        "a box between two corners",
        [] { return std::make_unique<Rectangle<dim>>(); }},
       {"L-shape",
        "a square without its lower right quadrant",
        [] { return std::make_unique<LShape<dim>>(); }},
       {"mesh file",
        "a mesh of quadrilaterals from a Gmsh, Abaqus or UCD file",
        [] { return std::make_unique<MeshFile<dim>>(); }}});
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
  } // namespace



  template <int dim>
  GeometryParameters<dim>::GeometryParameters()
    : name(all_geometries<dim>().names().front())
  {
    for (const std::string &each : all_geometries<dim>().names())
      geometries[each] = all_geometries<dim>().make(each);
  }



  template <int dim>
  void
  GeometryParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    const auto &all = all_geometries<dim>();
    prm.enter_subsection("Geometry");
    prm.add_parameter("Name",
                      name,
                      "The domain. " + all.documentation() +
                        " Only the subsection of the chosen one is used.",
                      dealii::Patterns::Selection(all.selection()));
    for (const std::string &each : all.names())
    {
      prm.enter_subsection(subsection_name(each));
      geometries.at(each)->add_parameters(prm);
      prm.leave_subsection();
    }
    prm.leave_subsection();
  }



  template <int dim>
  void
  GeometryParameters<dim>::check() const
  {
    chosen().check();
  }



  template <int dim>
  const Geometry<dim> &
  GeometryParameters<dim>::chosen() const
  {
    return *geometries.at(name);
  }



  template const Registry<Geometry<2>> &all_geometries<2>();
  template <int dim>
  std::vector<std::string>
  Geometry<dim>::names() const
  {
    std::vector<std::string> result;
    for (const auto &boundary : boundary_ids())
      result.push_back(boundary.first);
    for (const auto &point : named_points())
      result.push_back(point.first);
    return result;
  }



  template class Geometry<2>;
  template class GeometryParameters<2>;
} // namespace MixedCracks
