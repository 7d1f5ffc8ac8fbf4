// SPDX-License-Identifier: GPL-2.0-or-later
// From parameters to objects: mesh and refined regions, conditions on the
// boundary, loads. Named boundaries are known by their pieces on the coarse
// mesh, which every rank has; each face is cut into parts at its middle, which
// lies on a curved boundary where there is one.

#include <base/errors.h>

#include <deal.II/grid/grid_tools.h>

#include <simulation/simulation_setup.h>

#include <array>
#include <cmath>
#include <utility>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // the part of a face between one of its vertices and its middle: halves
    // in 2-d, quarters in 3-d
    template <int dim, typename Face>
    FlatPiece<dim>
    part_of_face(const Face &face, const unsigned int vertex)
    {
      if constexpr (dim == 2)
        return {{{face->vertex(vertex), face->center(true)}}};
      else
        // lines 0 and 1 run in the second direction of the face
        return {{{face->vertex(vertex),
                  face->line(2 + vertex / 2)->center(true),
                  face->line(vertex % 2)->center(true),
                  face->center(true)}}};
    }



    // every face in parts, so that curved boundaries are met
    template <int dim>
    std::vector<FlatPiece<dim>>
    pieces_of_boundary(const Triangulation<dim> &triangulation,
                       const BoundaryIds        &ids)
    {
      std::vector<FlatPiece<dim>> pieces;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              ids.contains(cell->face(f)->boundary_id()))
            for (const unsigned int v : cell->face(f)->vertex_indices())
              pieces.push_back(part_of_face<dim>(cell->face(f), v));
      return pieces;
    }



    // Loads on faces with two names, both of which have one.
    template <int dim>
    class SumOfFunctions : public Function<dim>
    {
    public:
      SumOfFunctions(std::shared_ptr<Function<dim>> one,
                     std::shared_ptr<Function<dim>> other)
        : Function<dim>(one->n_components)
        , summands{{std::move(one), std::move(other)}}
      {}

      double
      value(const Point<dim>  &point,
            const unsigned int component) const override
      {
        return summands[0]->value(point, component) +
               summands[1]->value(point, component);
      }

      void
      set_time(const double time) override
      {
        Function<dim>::set_time(time);
        for (const auto &summand : summands)
          summand->set_time(time);
      }

    private:
      std::array<std::shared_ptr<Function<dim>>, 2> summands;
    };



    template <int dim>
    void
    add_load(std::shared_ptr<Function<dim>>       &load,
             const std::shared_ptr<Function<dim>> &more)
    {
      load = load ? std::make_shared<SumOfFunctions<dim>>(load, more) : more;
    }
  } // namespace



  template <int dim>
  RefinementRegions<dim>
  refined_regions(const Parameters<dim>    &parameters,
                  const Triangulation<dim> &triangulation)
  {
    RefinementRegions<dim>     result;
    const Geometry<dim>       &geometry = parameters.geometry.chosen();
    const RefinedRegions<dim> &regions  = parameters.mesh.regions;
    for (const RefinedBox<dim> &box : regions.refined_boxes())
      result.boxes.push_back(
        {BoundingBox<dim>({box.lower, box.upper}), box.levels});
    for (const RefinedDisc<dim> &disc : regions.refined_discs())
      result.surroundings.push_back(
        {{FlatPiece<dim>::point(disc.center)}, disc.radius, disc.levels});
    const auto places     = geometry.named_places();
    const auto boundaries = geometry.boundary_ids();
    for (const RefinedSurroundings &named : regions.refined_surroundings())
    {
      const auto place = places.find(named.name);
      result.surroundings.push_back(
        {place == places.end()
           ? pieces_of_boundary(triangulation, boundaries.at(named.name))
           : std::vector<FlatPiece<dim>>{place->second},
         named.distance,
         named.levels});
    }
    return result;
  }



  template <int dim>
  void
  make_coarse_mesh(const Parameters<dim> &parameters,
                   const Geometry<dim>   &geometry,
                   Triangulation<dim>    &triangulation)
  {
    geometry.create(triangulation);
    make_periodic(parameters, triangulation);
    // what only the mesh of a file can tell
    parameters.mesh.check(GridTools::compute_bounding_box(triangulation),
                          geometry.names());
  }



  template <int dim>
  void
  make_mesh(const Parameters<dim> &parameters,
            Triangulation<dim>    &triangulation)
  {
    make_coarse_mesh(parameters, parameters.geometry.chosen(), triangulation);
    refine_globally_and_in_regions(triangulation,
                                   parameters.mesh.global_refinements,
                                   refined_regions(parameters, triangulation));
  }



  // h: the mean of measure^(1/dim) over the cells of the highest level of all
  // ranks; the edge of a square or cube, whatever the shape of the cells.
  template <int dim>
  double
  finest_cell_size(const Triangulation<dim> &triangulation,
                   const MPI_Comm            communicator)
  {
    const int finest = Utilities::MPI::max(
      static_cast<int>(triangulation.n_levels()), communicator);
    std::vector<double> sums(2, 0.);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->level() == finest - 1)
      {
        sums[0] += std::pow(cell->measure(), 1. / dim);
        sums[1] += 1.;
      }
    Utilities::MPI::sum(sums, communicator, sums);
    return sums[0] / sums[1];
  }



  // In the order of the .prm, on which depends what holds where two boundaries
  // meet. Those of the phase field are in prescribed_phase_field().
  template <int dim>
  std::vector<PrescribedComponent<dim>>
  prescribed_components(const Parameters<dim> &parameters,
                        const unsigned int     n_components)
  {
    const auto ids = parameters.geometry.chosen().boundary_ids();
    std::vector<PrescribedComponent<dim>> result;
    for (const auto &entry : parameters.boundary_conditions.displacements())
      if (entry.component != dim)
      {
        const bool is_symmetry =
          entry.component == BoundaryEntry<dim>::symmetry;
        auto value = std::make_shared<ExpressionFunction<dim>>(n_components);
        if (!is_symmetry) // else 0
          value->set(entry.component, entry.expression, entry.rotation);
        result.push_back(
          {ids.at(entry.boundary),
           is_symmetry ? PrescribedComponent<dim>::normal : entry.component,
           value,
           entry.boundary});
      }
    return result;
  }



  template <int dim>
  Loads<dim>
  make_loads(const Parameters<dim>    &parameters,
             const unsigned int        n_components,
             const Triangulation<dim> &triangulation,
             const bool                stands_for_finer)
  {
    const auto &conditions = parameters.boundary_conditions;
    const auto  ids        = parameters.geometry.chosen().boundary_ids();
    Loads<dim>  loads;
    loads.body_force = conditions.body_force(n_components);
    for (const auto &[boundary, traction] : conditions.tractions(n_components))
      for (const types::boundary_id id : ids.at(boundary))
        add_load<dim>(loads.tractions[id], traction);
    for (const auto &[boundary, traction] : conditions.normal_tractions())
      for (const types::boundary_id id : ids.at(boundary))
        add_load<dim>(loads.normal_tractions[id], traction);
    for (const auto &[boundary, pressure] : conditions.pressures())
      for (const types::boundary_id id : ids.at(boundary))
        add_load<dim>(loads.pressures[id], pressure);
    std::vector<PointForce<dim>> forces;
    for (const auto &entry :
         points_with_forces(parameters, triangulation, stands_for_finer))
    {
      auto value = std::make_shared<ExpressionFunction<dim>>(n_components);
      value->set(entry.component, entry.expression);
      forces.push_back(
        {entry.point, entry.component, value, !entry.set.empty()});
    }
    loads.at_points = {forces, parameters.thickness_factor()};
    return loads;
  }



  template <int dim>
  std::shared_ptr<FluidAssembler<dim>>
  make_fluid(const Parameters<dim> &parameters, const Fields<dim> &fields)
  {
    const auto pressure = parameters.fluid.pressure();
    if (!pressure)
      return nullptr;
    return std::make_shared<FluidAssembler<dim>>(fields, pressure);
  }



#define INSTANTIATE(dim)                                                       \
  template RefinementRegions<dim> refined_regions(const Parameters<dim> &,     \
                                                  const Triangulation<dim> &); \
  template void make_mesh(const Parameters<dim> &, Triangulation<dim> &);      \
  template void make_coarse_mesh(                                              \
    const Parameters<dim> &, const Geometry<dim> &, Triangulation<dim> &);     \
  template double finest_cell_size(const Triangulation<dim> &, MPI_Comm);      \
  template std::vector<PrescribedComponent<dim>> prescribed_components(        \
    const Parameters<dim> &, unsigned int);                                    \
  template Loads<dim> make_loads(                                              \
    const Parameters<dim> &, unsigned int, const Triangulation<dim> &, bool);  \
  template std::shared_ptr<FluidAssembler<dim>> make_fluid(                    \
    const Parameters<dim> &, const Fields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace MixedCracks
