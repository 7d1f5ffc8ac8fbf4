// SPDX-License-Identifier: GPL-2.0-or-later
// The variable 'map' of the material: values of a file at x, in 3-d (x, y, z).
//
//   picture   pixel (i, j) covers a rectangle between the given corners, or the
//             corners of the body; its value belongs to the middle of it,
//               x_i = lower + (upper - lower) (i + 1/2)/width.
//             The first row of a picture is its top, largest y. Same for all z.
//   table     values at the nodes of a grid with its own coordinates
//
// 'nearest' keeps sharp interfaces, which lie between the pixels; with 'linear'
// they are as wide as a pixel.

#include <base/errors.h>
#include <base/text.h>

#include <deal.II/base/patterns.h>

#include <problem/geometries/checks.h>
#include <problem/geometries/mesh_reader.h>
#include <problem/material_map.h>

namespace MixedCracks
{
  namespace
  {
    const std::string subsection = "Material/Map/";

    // One corner of a picture, as given or that of the mesh.
    template <int dim>
    dealii::Point<dim>
    corner(const std::string        &text,
           const std::string        &parameter,
           const dealii::Point<dim> &of_mesh)
    {
      if (text.empty())
        return of_mesh;
      const std::vector<double> numbers = parse_numbers(text, parameter);
      require(numbers.size() == 2,
              parameter + ": found " + in_quotes(text) +
                ", allowed are two numbers, as '0, 0': a picture lies in x "
                "and y.");
      dealii::Point<dim> result = of_mesh;
      for (unsigned int d = 0; d < 2; ++d)
        result[d] = numbers[d];
      return result;
    }

    template <int dim>
    GridData
    picture_on_grid(const Picture                  &picture,
                    const MaterialMapParameters    &parameters,
                    const dealii::BoundingBox<dim> &box)
    {
      const auto lower = corner(parameters.lower_corner,
                                subsection + "Lower corner",
                                box.get_boundary_points().first);
      const auto upper = corner(parameters.upper_corner,
                                subsection + "Upper corner",
                                box.get_boundary_points().second);
      require(upper[0] > lower[0] && upper[1] > lower[1],
              subsection + "Upper corner is " +
                point_text({upper[0], upper[1]}) +
                "; both coordinates must be greater than those of the lower "
                "corner, " +
                point_text({lower[0], lower[1]}) + ".");
      const std::size_t sizes[]               = {picture.width, picture.height};
      std::array<std::vector<double>, 3> axes = {{{}, {}, {0.}}};
      for (unsigned int d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < sizes[d]; ++i)
          axes[d].push_back(lower[d] + (upper[d] - lower[d]) * (i + 0.5) /
                                         static_cast<double>(sizes[d]));
      // the first row is the uppermost
      std::vector<double> values;
      values.reserve(picture.values.size());
      for (std::size_t row = picture.height; row-- > 0;)
        values.insert(values.end(),
                      picture.values.begin() + row * picture.width,
                      picture.values.begin() + (row + 1) * picture.width);
      return {axes,
              values,
              parameters.interpolation == "linear"
                ? GridData::Interpolation::linear
                : GridData::Interpolation::nearest};
    }
  } // namespace



  void
  MaterialMapParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Map");
    prm.add_parameter(
      "File name",
      file_name,
      "What the expressions of the material know as 'map': a gray-scale "
      "picture (PGM, P2 or P5; 0 is black, 1 is white; in 3-d the same for all "
      "z), or a table of 'x, y, value' or 'x, y, z, value' in each line, which "
      "are the nodes of a grid parallel to the axes (CSV; mm). Beyond its edge "
      "the map goes on as at the edge. A relative path starts at the .prm that "
      "sets it, or else at the working directory. Empty: no map.",
      FileName(FileName::input));
    prm.add_parameter("Lower corner",
                      lower_corner,
                      "Lower left corner of a picture, 'x, y'; empty: that of "
                      "the mesh. A table has its own coordinates. Unit: mm.",
                      Anything());
    prm.add_parameter("Upper corner",
                      upper_corner,
                      "Upper right corner of a picture, likewise. Unit: mm.",
                      Anything());
    prm.add_parameter("Interpolation",
                      interpolation,
                      "Between the centers of pixels, or nodes of a table: "
                      "'nearest': the value of the nearest; 'linear': linear "
                      "in each coordinate.",
                      Selection("nearest|linear"));
    prm.leave_subsection();
  }



  template <int dim>
  std::shared_ptr<const GridData>
  read_material_map(const MaterialMapParameters    &parameters,
                    const dealii::BoundingBox<dim> &box,
                    const MPI_Comm                  communicator)
  {
    const std::string parameter = subsection + "File name";
    const std::string text =
      read_file_once(parameters.file_name, communicator, parameter);
    const std::string file =
      parameter + ": the file '" + parameters.file_name + "' ";
    if (looks_like_picture(text))
    {
      Picture           picture;
      const std::string problem = read_picture(text, picture);
      if (!problem.empty())
        throw FileError(file + problem + ".");
      return std::make_shared<GridData>(
        picture_on_grid<dim>(picture, parameters, box));
    }
    Table             table;
    const std::string problem = read_table(text, dim, table);
    if (!problem.empty())
      throw FileError(file + problem + ".");
    require(parameters.lower_corner.empty() && parameters.upper_corner.empty(),
            subsection + "Lower corner and Upper corner are for pictures; " +
              "the table '" + parameters.file_name +
              "' has its own coordinates. Allowed: nothing.");
    return std::make_shared<GridData>(table.axes,
                                      table.values,
                                      parameters.interpolation == "linear"
                                        ? GridData::Interpolation::linear
                                        : GridData::Interpolation::nearest);
  }



  template std::shared_ptr<const GridData>
  read_material_map(const MaterialMapParameters &,
                    const dealii::BoundingBox<2> &,
                    MPI_Comm);
  template std::shared_ptr<const GridData>
  read_material_map(const MaterialMapParameters &,
                    const dealii::BoundingBox<3> &,
                    MPI_Comm);
} // namespace MixedCracks
