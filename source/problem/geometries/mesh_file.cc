// SPDX-License-Identifier: GPL-2.0-or-later
// A mesh from a file, in four stages that know nothing of each other:
//
//   text      mesh_reader.cc         read on one rank, handed to all
//   contents  mesh_scan*.cc          nodes, cells, groups of a format, cut into
//                                    quadrilaterals or hexahedra, mesh_cut.cc
//   mesh      mesh_builder.cc        checked, turned and numbered for deal.II
//   names     mesh_builder_boundaries.cc   ids of boundaries by the .prm
//
// All ranks do the last three alike: the coarse mesh has to be the same
// everywhere. Boundaries that the .prm knows by a number keep it as their id;
// those known by a name get ids above the largest number that a file may use.
// What names there are the file tells as well, so that it is read once more
// when a case is checked.

#include <base/coordinates.h>
#include <base/text.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>
#include <deal.II/grid/manifold_lib.h>

#include <problem/geometries/checks.h>
#include <problem/geometries/mesh_file.h>
#include <problem/geometries/mesh_reader.h>
#include <problem/geometries/mesh_scan.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace MixedCracks
{
  namespace
  {
    const std::string subsection = "Geometry/Mesh file/";

    // Boundaries that a name in the file stands for get ids from here on.
    constexpr dealii::types::boundary_id first_free_id = 1000000001;

    bool
    is_number(const std::string &text)
    {
      char *behind = nullptr;
      std::strtod(text.c_str(), &behind);
      return *behind == '\0';
    }



    // What was done to the cells of the file
    std::string
    in_words(const MeshScan &scan)
    {
      const std::string cut =
        scan.is_cut ? "each cell of the file cut at its corners" : "";
      if (scan.contents.n_second_order == 0)
        return cut;
      return cut + (cut.empty() ? "" : "; ") + "of " +
             std::to_string(scan.contents.n_second_order) +
             " cells of second order the corners, so that curved edges are "
             "straight (but for Circles)";
    }
  } // namespace



  template <int dim>
  void
  MeshFile<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    prm.add_parameter(
      "File name",
      file_name,
      "Gmsh .msh (version 2 or 4, ASCII or binary), Abaqus .inp, UCD or legacy "
      "VTK mesh (ASCII) of quadrilaterals, in 3-d of hexahedra; of elements "
      "of second order the corners are used. Lengths in mm. A relative path "
      "starts at the .prm that sets it, or else at the working directory.",
      dealii::Patterns::FileName(dealii::Patterns::FileName::input));
    prm.add_parameter("Cut simplices",
                      cut_simplices,
                      "Whether a mesh that has other cells, too, is taken: "
                      "each triangle is cut into three quadrilaterals by the "
                      "middles of its edges and its centroid, each "
                      "quadrilateral beside triangles into four; in 3-d a "
                      "tetrahedron into four hexahedra, a prism into six, a "
                      "hexahedron beside them into eight. Cells become half "
                      "as long. Pyramids cannot be cut.");
    prm.add_parameter("Boundary names",
                      boundary_names,
                      "Names for parts of the boundary, as in '1 = bottom ; 2 "
                      "= top ; TopEdge = grip': left the id or name in the "
                      "file. Ids are the numbers of Gmsh's physical curves, in "
                      "3-d surfaces, of Abaqus surfaces named SS1, SS2, ..., "
                      "or the materials of UCD and VTK lines, in 3-d faces; "
                      "names are those of Gmsh's physical groups and of "
                      "Abaqus' surfaces, sets of elements of one dimension "
                      "less, and sets of nodes (all faces whose nodes are in "
                      "it). The rest of the boundary has the id 0. A face in "
                      "several parts has all of their names. Names of the file "
                      "hold as they are where none is given here.",
                      Anything());
    prm.add_parameter("Circles",
                      circles,
                      "Boundaries that are (parts of) circles, so that "
                      "refinement puts new nodes on them: 'name : x, y : "
                      "radius ; ...'; mm. In 3-d this is a cylinder along z, "
                      "and 'name : x, y, z : radius' a sphere.",
                      Anything());
  }



  template <int dim>
  void
  MeshFile<dim>::check() const
  {
    require(!file_name.empty(),
            subsection + "File name is empty; the geometry 'mesh file' needs "
                         "the path of a mesh.");
    parsed_names();
    boundaries(MPI_COMM_WORLD);
    parsed_circles();
  }



  template <int dim>
  std::vector<BoundaryName>
  MeshFile<dim>::parsed_names() const
  {
    const std::string         parameter = subsection + "Boundary names";
    std::vector<BoundaryName> result;
    std::set<std::string>     keys, names;
    for (const std::string &item : split_list(boundary_names, ';'))
    {
      const std::vector<std::string> parts = split_list(item, '=');
      require(parts.size() == 2,
              parameter + ": " + in_quotes(item) +
                " is not of the form 'id = name'.");
      BoundaryName name{single_spaced(parts[0]), single_spaced(parts[1]), {}};
      name.id = first_free_id + static_cast<unsigned int>(result.size());
      if (is_number(name.key))
      {
        name.id  = read_id(name.key, "boundary", parameter);
        name.key = std::to_string(name.id);
      }
      require(keys.insert(name.key).second,
              parameter + ": the boundary id " + parts[0] + " has two names.");
      require(names.insert(name.name).second,
              parameter + ": the name " + in_quotes(parts[1]) +
                " stands for two boundary ids.");
      result.push_back(name);
    }
    return result;
  }



  template <int dim>
  FileBoundaries
  MeshFile<dim>::build(const std::string          &text,
                       dealii::Triangulation<dim> &mesh) const
  {
    bool is_built = false;
    try
    {
      const MeshScan   scan = scan_mesh(text, dim, cut_simplices);
      MeshBuilder<dim> builder(scan.contents);
      builder.build(mesh);
      is_built = true;
      remarks  = in_words(scan);
      return builder.set_boundary_ids(parsed_names(), mesh);
    }
    catch (const MeshProblem &problem)
    {
      throw InputError(is_built ? subsection + "Boundary names: " +
                                    problem.what() + " ('" + file_name + "')."
                                : subsection + "File name: the file '" +
                                    file_name + "' " + problem.what() + ".");
    }
  }



  // of all entries that boundaries() depends on
  template <int dim>
  std::string
  MeshFile<dim>::what_is_read() const
  {
    return file_name + '\n' + boundary_names + (cut_simplices ? "\ncut" : "");
  }



  template <int dim>
  const FileBoundaries &
  MeshFile<dim>::boundaries(const MPI_Comm reading) const
  {
    const std::string key = what_is_read();
    if (read_for != key)
    {
      read_mesh = std::make_unique<dealii::Triangulation<dim>>();
      known =
        build(read_file_once(file_name, reading, subsection + "File name"),
              *read_mesh);
      read_for = key;
    }
    return known;
  }



  template <int dim>
  NamedBoundaries
  MeshFile<dim>::boundary_ids() const
  {
    return boundaries(MPI_COMM_SELF).ids;
  }



  template <int dim>
  std::map<dealii::types::boundary_id, std::string>
  MeshFile<dim>::names_of_ids() const
  {
    return boundaries(MPI_COMM_SELF).names;
  }



  template <int dim>
  std::vector<typename MeshFile<dim>::Circle>
  MeshFile<dim>::parsed_circles() const
  {
    const std::string   parameter = subsection + "Circles";
    const auto          ids       = boundary_ids();
    std::vector<Circle> result;
    for (const auto &parts :
         read_items(circles, "name : x, y : radius", parameter))
    {
      const std::string         name   = single_spaced(parts[0]);
      const BoundaryIds        &id     = boundary_of(name, ids, parameter);
      const std::vector<double> center = parse_numbers(parts[1], parameter);
      require(center.size() == 2 || center.size() == dim,
              parameter + ": the centre " + in_quotes(parts[1]) + " needs 2" +
                (dim == 3 ? " (cylinder) or 3 (sphere)" : "") + " numbers.");
      const double radius = parse_number(parts[2], parameter);
      require(radius > 0.,
              parameter + ": the radius " + in_quotes(parts[2]) +
                " must be greater than 0.");
      Circle circle = {id, name, {}, radius, center.size() < dim};
      set_coordinates(center, circle.center);
      result.push_back(circle);
    }
    return result;
  }



  template <int dim>
  void
  MeshFile<dim>::create(dealii::Triangulation<dim> &triangulation) const
  {
    // Every rank reads, or none: a rank that was asked for names alone has done
    // so before the others.
    const MPI_Comm communicator = triangulation.get_communicator();
    const int has_mesh = read_mesh != nullptr && read_for == what_is_read();
    if (dealii::Utilities::MPI::min(has_mesh, communicator) == 0)
      read_for.clear();
    boundaries(communicator);
    // a serial mesh, every rank's own; the next one is read anew
    const std::unique_ptr<dealii::Triangulation<dim>> owned =
      std::move(read_mesh);
    dealii::Triangulation<dim> &mesh = *owned;

    mesh.reset_all_manifolds();
    mesh.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
    triangulation.copy_triangulation(mesh);
    dealii::types::manifold_id manifold = 0;
    for (const Circle &circle : parsed_circles())
      set_circle(triangulation, circle, ++manifold);
  }



  template <int dim>
  std::string
  MeshFile<dim>::hint_about_boundaries() const
  {
    const std::string names = subsection + "Boundary names";
    try
    {
      const std::string text =
        read_file_once(file_name, MPI_COMM_SELF, subsection + "File name");
      const MeshScan             scan = scan_mesh(text, dim, cut_simplices);
      MeshBuilder<dim>           builder(scan.contents);
      dealii::Triangulation<dim> mesh;
      builder.build(mesh);
      return "The boundary of the file '" + file_name + "' has " +
             builder.known_boundaries() + "; " + names +
             " gives them names, as in '1 = bottom', and Geometry/Boundary "
             "regions names parts by their position.";
    }
    catch (const std::runtime_error &)
    {
      return "Names are given in " + names + ".";
    }
  }



  template <int dim>
  void
  MeshFile<dim>::set_circle(dealii::Triangulation<dim>      &triangulation,
                            const Circle                    &circle,
                            const dealii::types::manifold_id id) const
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        const auto face = cell->face(f);
        if (!face->at_boundary() ||
            !circle.boundary.contains(face->boundary_id()))
          continue;
        for (const unsigned int v : face->vertex_indices())
        {
          const double distance = circle.distance(face->vertex(v));
          require(std::abs(distance - circle.radius) < 1e-3 * circle.radius,
                  subsection + "Circles: a node of the boundary '" +
                    circle.name + "' is " + number_text(distance) +
                    " mm from the " + (circle.is_cylinder ? "axis" : "centre") +
                    ", not " + number_text(circle.radius) + " mm.");
        }
        face->set_all_manifold_ids(id); // in 3-d of its edges, too
      }
    triangulation.set_manifold(id, *manifold(circle));
  }



  template <int dim>
  double
  MeshFile<dim>::Circle::distance(const dealii::Point<dim> &point) const
  {
    dealii::Tensor<1, dim> from_center = point - center;
    if (is_cylinder)
      from_center[dim - 1] = 0.;
    return from_center.norm();
  }



  template <int dim>
  std::unique_ptr<dealii::Manifold<dim, dim>>
  MeshFile<dim>::manifold(const Circle &circle) const
  {
    if constexpr (dim == 3)
      if (circle.is_cylinder)
        return std::make_unique<dealii::CylindricalManifold<dim>>(
          dealii::Tensor<1, dim>({0., 0., 1.}), circle.center);
    return std::make_unique<dealii::SphericalManifold<dim>>(circle.center);
  }



  template class MeshFile<2>;
  template class MeshFile<3>;
} // namespace MixedCracks
