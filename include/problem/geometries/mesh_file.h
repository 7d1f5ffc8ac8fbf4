// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_file_h
#define mixed_cracks_problem_geometries_mesh_file_h

#include <problem/geometries/mesh_builder.h>
#include <problem/geometry.h>

#include <memory>

namespace MixedCracks
{
  /// A mesh of quadrilaterals, in 3-d of hexahedra, from a file: Gmsh (.msh),
  /// Abaqus (.inp), UCD (.inp, .ucd) or legacy VTK, told apart by content;
  /// triangles, tetrahedra and prisms are cut when asked for. Parts of the
  /// boundary (Gmsh: physical curves or surfaces; Abaqus: surfaces and sets;
  /// UCD: materials of lines or quadrilaterals) get their names in the .prm;
  /// material ids are kept.
  template <int dim>
  class MeshFile : public Geometry<dim>
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm) override;

    /// One rank reads the file. Throws as create().
    void check() const override;

    /// Those of the .prm, and under the names of the file the others. Reads it
    /// where check() has not, on this rank alone.
    NamedBoundaries boundary_ids() const override;

    std::map<dealii::types::boundary_id, std::string>
    names_of_ids() const override;

    std::optional<dealii::BoundingBox<dim>>
    extent() const override
    {
      return {};
    }

    /// One rank reads the file. Throws FileError when that fails, InputError
    /// when it is no usable mesh or not the one that the entries describe; on
    /// every rank alike.
    void create(dealii::Triangulation<dim> &triangulation) const override;

    /// After create(): whether cells were cut, and which nodes were not used.
    std::string
    about_mesh() const override
    {
      return remarks;
    }

    /// What parts of the boundary the file has. Reads it, on this rank alone.
    std::string hint_about_boundaries() const override;

  private:
    /// A boundary that is part of a circle; in 3-d of a sphere, or of a
    /// cylinder along z.
    struct Circle
    {
      BoundaryIds        boundary;
      std::string        name;
      dealii::Point<dim> center;
      double             radius;
      bool               is_cylinder;

      double distance(const dealii::Point<dim> &point) const;
    };

    std::unique_ptr<dealii::Manifold<dim, dim>>
    manifold(const Circle &circle) const;

    std::vector<Circle> parsed_circles() const;

    std::vector<BoundaryName> parsed_names() const;

    void set_circle(dealii::Triangulation<dim> &triangulation,
                    const Circle               &circle,
                    dealii::types::manifold_id  id) const;

    /// The mesh of the file with that @p text, which goes into @p mesh, and
    /// what it calls the parts of its boundary.
    FileBoundaries build(const std::string          &text,
                         dealii::Triangulation<dim> &mesh) const;

    const FileBoundaries &boundaries(MPI_Comm reading) const;

    std::string what_is_read() const;

    std::string file_name;
    std::string boundary_names;
    std::string circles;
    bool        cut_simplices = false;

    /// of the file and names that are in `read_for`, to read it once
    mutable FileBoundaries known;
    mutable std::string    read_for;
    /// The mesh that was read with them, until create() takes it
    mutable std::unique_ptr<dealii::Triangulation<dim>> read_mesh;
    /// See about_mesh()
    mutable std::string remarks;
  };
} // namespace MixedCracks

#endif
