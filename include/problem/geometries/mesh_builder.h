// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_problem_geometries_mesh_builder_h
#define mixed_cracks_problem_geometries_mesh_builder_h

#include <deal.II/grid/tria.h>

#include <problem/geometries/mesh_contents.h>

#include <map>
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

  /// Makes the cells of a file a serial triangulation.
  template <int dim>
  class MeshBuilder
  {
  public:
    /// @p contents must outlive the object.
    explicit MeshBuilder(const MeshContents &contents);

    /// Make @p triangulation, which is empty. Returns why that is impossible,
    /// as the end of a sentence that begins "the file"; empty when it worked.
    std::string build(dealii::Triangulation<dim> &triangulation);

    /// After build(): give the faces of the boundary the ids of @p names, and
    /// those that no name stands for their number in the file or 0. Faces
    /// inside the body may be in groups that have no name. Returns what is
    /// wrong with the names or the groups they stand for, a sentence without
    /// its stop; empty when it worked.
    std::string
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

    // the ends of a sentence, like build()
    std::string check_plane() const;
    std::string collect_cells();
    void        add_cell(const MeshContents::Cell &cell);
    void        collect_groups();

    std::string node_list(const Face &face) const;

    // Like set_boundary_ids(): groups with names have no faces elsewhere
    std::string
    check_inner_faces(const std::vector<BoundaryName> &names,
                      const std::vector<unsigned int> &name_of_group) const;

    const MeshContents                       &contents;
    std::vector<dealii::CellData<dim>>        cells;
    std::vector<dealii::Point<dim>>           vertices;
    std::vector<unsigned int>                 node_of_vertex, vertex_of_node;
    std::map<Face, FaceOfCells>               faces_of_cells;
    std::map<Face, std::vector<unsigned int>> groups_at;
  };
} // namespace MixedCracks

#endif
