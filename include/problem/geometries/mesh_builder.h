// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_builder_h
#define mixed_cracks_problem_geometries_mesh_builder_h

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <discretization/boundary_ids.h>

#include <problem/geometries/mesh_contents.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// A part of the boundary that the .prm names.
  struct BoundaryName
  {
    std::string                key;  ///< number or name in the file
    std::string                name; ///< in the .prm
    dealii::types::boundary_id id;   ///< what its faces get
  };

  /// The boundaries of a mesh from a file.
  struct FileBoundaries
  {
    /// those of the .prm and, under the names of the file, the other groups
    /// that consist of faces of the boundary
    NamedBoundaries ids;
    /// of several names of a face the one of the .prm, or else that of the
    /// smallest part
    std::map<dealii::types::boundary_id, std::string> names;
  };

  /// Makes the cells of a file a serial triangulation.
  template <int dim>
  class MeshBuilder
  {
  public:
    /// @p contents must outlive the object.
    explicit MeshBuilder(const MeshContents &contents)
      : contents(contents)
    {}

    /// Make @p triangulation, which is empty. Throws a MeshProblem where
    /// that is impossible.
    void build(dealii::Triangulation<dim> &triangulation);

    /// After build(): give the faces of the boundary ids that tell what names
    /// they have, those of @p names and of the file; those without a name get
    /// their number in the file or 0. Groups with faces inside the body have no
    /// name unless @p names has one, which is an error. Throws what is wrong
    /// with the names or the groups they stand for, a sentence without its
    /// stop, as a MeshProblem.
    FileBoundaries
    set_boundary_ids(const std::vector<BoundaryName> &names,
                     dealii::Triangulation<dim>      &triangulation) const;

    /// After build(): what the boundary consists of, as "the ids 0, 1 ('left')
    /// and the names 'top'".
    std::string known_boundaries() const;

  private:
    using Face = std::vector<unsigned int>; // sorted indices of nodes

    struct FaceOfCells
    {
      unsigned int n_cells;  // 1 or 2
      unsigned int opposite; // see across_from_first()
    };

    void check_plane() const;
    void collect_cells();
    void add_cell(const MeshContents::Cell &cell);
    void collect_groups();

    std::string node_list(const Face &face) const;

    // The end of set_boundary_ids(): names of faces that are in no group
    void name_the_rest(const std::vector<BoundaryName>            &names,
                       const std::set<dealii::types::boundary_id> &without_name,
                       FileBoundaries &boundaries) const;

    // Like set_boundary_ids(): groups with names have no faces elsewhere
    void
    check_inner_faces(const std::vector<BoundaryName> &names,
                      const std::vector<unsigned int> &name_of_group) const;

    // For each group what it is called, or nothing
    std::vector<std::string>
    names_of_groups(const std::vector<BoundaryName> &names,
                    const std::vector<unsigned int> &name_of_group) const;

    // For each face of the boundary its names, in order
    std::map<Face, std::vector<std::string>>
    names_of_faces(const std::vector<std::string> &group_names) const;

    const MeshContents                       &contents;
    std::vector<dealii::CellData<dim>>        cells;
    std::vector<dealii::Point<dim>>           vertices;
    std::vector<unsigned int>                 node_of_vertex, vertex_of_node;
    std::map<Face, FaceOfCells>               faces_of_cells;
    std::map<Face, std::vector<unsigned int>> groups_at;
  };
} // namespace MixedCracks

#endif
