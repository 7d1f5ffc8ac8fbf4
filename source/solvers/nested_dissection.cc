// SPDX-License-Identifier: GPL-2.0-or-later
// The graph that is dissected has one vertex for all unknowns whose rows have
// the same columns, as the components of one node do. Rank 0 holds it, with
// METIS at the peak about 20 bytes for each pair of neighbours: 0.2 kB per
// unknown of triquadratic displacements and trilinear pressures on a uniform
// mesh, where factors take several kB.

#include <solvers/nested_dissection.h>

#ifdef MIXED_CRACKS_WITH_METIS

#  include <deal.II/base/exceptions.h>
#  include <deal.II/base/mpi.h>

#  include <metis.h>

#  include <algorithm>
#  include <climits>
#  include <csignal>
#  include <cstddef>
#  include <unordered_map>

namespace MixedCracks
{
  using namespace dealii;

  namespace
  {
    // of a row of this rank; by their numbers in the whole, in order
    std::vector<int>
    columns_of(const Epetra_CrsMatrix &matrix, const int row)
    {
      int     n;
      int    *local_columns;
      double *unused;
      matrix.ExtractMyRowView(row, n, unused, local_columns);
      std::vector<int> columns(n);
      for (int k = 0; k < n; ++k)
        columns[k] = matrix.GCID(local_columns[k]);
      std::sort(columns.begin(), columns.end());
      return columns;
    }



    std::size_t
    hash_of(const std::vector<int> &numbers)
    {
      std::size_t result = numbers.size();
      for (const int number : numbers)
        result = (result ^ number) * 1099511628211u;
      return result;
    }



    // For each unknown the first one of its rank with the same columns.
    std::vector<int>
    groups_of(const Epetra_CrsMatrix &matrix, const MPI_Comm communicator)
    {
      std::vector<int>                     groups(matrix.NumGlobalRows(), 0);
      std::unordered_map<std::size_t, int> first_with;
      for (int row = 0; row < matrix.NumMyRows(); ++row)
      {
        const std::vector<int> columns = columns_of(matrix, row);
        const int              first =
          first_with.emplace(hash_of(columns), row).first->second;
        // hashes of different columns may be the same
        const bool is_equal =
          first == row || columns_of(matrix, first) == columns;
        groups[matrix.GRID(row)] = matrix.GRID(is_equal ? first : row);
      }
      Utilities::MPI::max(groups, communicator, groups);
      return groups;
    }



    // Group, number of neighbours, neighbours; the next group. Of a symmetric
    // matrix only neighbours with smaller numbers: each edge once.
    std::vector<int>
    neighbours_of_groups(const Epetra_CrsMatrix &matrix,
                         const std::vector<int> &groups,
                         const MatrixSymmetry    symmetry)
    {
      std::vector<int> result, neighbours;
      for (int row = 0; row < matrix.NumMyRows(); ++row)
      {
        const int group = groups[matrix.GRID(row)];
        if (group != matrix.GRID(row))
          continue;
        neighbours.clear();
        for (const int column : columns_of(matrix, row))
          if (groups[column] < group ||
              (groups[column] > group && symmetry == MatrixSymmetry::none))
            neighbours.push_back(groups[column]);
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()),
                         neighbours.end());
        result.push_back(group);
        result.push_back(neighbours.size());
        result.insert(result.end(), neighbours.begin(), neighbours.end());
      }
      return result;
    }



    // On rank 0, one rank after the other.
    std::vector<int>
    gathered(const std::vector<int> &mine, const MPI_Comm communicator)
    {
      const int        n       = mine.size();
      const int        n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      std::vector<int> counts(n_ranks), offsets(n_ranks, 0);
      MPI_Gather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, communicator);
      std::vector<int> all;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (int rank = 1; rank < n_ranks; ++rank)
          offsets[rank] = offsets[rank - 1] + counts[rank - 1];
        all.resize(offsets.back() + counts.back());
      }
      MPI_Gatherv(mine.data(),
                  n,
                  MPI_INT,
                  all.data(),
                  counts.data(),
                  offsets.data(),
                  MPI_INT,
                  0,
                  communicator);
      return all;
    }



    // call(group, neighbour) for each pair of what neighbours_of_groups() has
    template <typename Call>
    void
    for_each_edge(const std::vector<int> &edges, const Call &call)
    {
      for (std::size_t k = 0; k < edges.size(); k += 2 + edges[k + 1])
        for (int i = 0; i < edges[k + 1]; ++i)
          call(edges[k], edges[k + 2 + i]);
    }



    // As METIS takes it: neighbours of vertex v from starts[v] to
    // starts[v + 1], in both directions, each once.
    struct Graph
    {
      // of the vertices; those without neighbours are none
      std::vector<int>   names;
      std::vector<idx_t> starts, neighbours, weights;
    };



    Graph
    make_graph(const std::vector<int> &edges, const std::vector<int> &sizes)
    {
      std::vector<int> degree(sizes.size(), 0), vertex(sizes.size(), -1);
      for_each_edge(edges, [&](const int a, const int b) {
        ++degree[a];
        ++degree[b];
      });
      Graph graph;
      graph.starts.push_back(0);
      for (std::size_t name = 0; name < sizes.size(); ++name)
        if (degree[name] > 0)
        {
          vertex[name] = graph.names.size();
          graph.names.push_back(name);
          graph.weights.push_back(sizes[name]);
          graph.starts.push_back(graph.starts.back() + degree[name]);
        }
      graph.neighbours.resize(graph.starts.back());
      std::vector<idx_t> next(graph.starts);
      for_each_edge(edges, [&](const int a, const int b) {
        graph.neighbours[next[vertex[a]]++] = vertex[b];
        graph.neighbours[next[vertex[b]]++] = vertex[a];
      });
      // what is in the rows of both ends came twice
      const auto begin = graph.neighbours.begin();
      auto       end   = begin;
      for (std::size_t v = 0; v < graph.names.size(); ++v)
      {
        const auto first = begin + graph.starts[v];
        const auto last  = begin + next[v];
        std::sort(first, last);
        graph.starts[v] = end - begin;
        end             = std::copy(first, std::unique(first, last), end);
      }
      graph.starts.back() = end - begin;
      graph.neighbours.resize(end - begin);
      return graph;
    }



    // METIS has handlers of its own for SIGTERM while it works, and would take
    // a request to stop the run for a failure: it comes afterwards.
    class SigtermComesLater
    {
    public:
      SigtermComesLater()
      {
        sigset_t waiting;
        sigemptyset(&waiting);
        sigaddset(&waiting, SIGTERM);
        pthread_sigmask(SIG_BLOCK, &waiting, &before);
      }

      ~SigtermComesLater()
      {
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
      }

    private:
      sigset_t before;
    };



    // The result of METIS, and the vertices in the order found.
    int
    dissect(Graph &graph, std::vector<idx_t> &order)
    {
      idx_t              n = graph.names.size();
      std::vector<idx_t> places(n);
      order.resize(n);
      if (n == 0)
        return METIS_OK;
      idx_t options[METIS_NOPTIONS];
      METIS_SetDefaultOptions(options);
      options[METIS_OPTION_NUMBERING] = 0;
      // the same order in each run
      options[METIS_OPTION_SEED] = 1;
      // it is, already
      options[METIS_OPTION_COMPRESS] = 0;
      const SigtermComesLater later;
      return METIS_NodeND(&n,
                          graph.starts.data(),
                          graph.neighbours.data(),
                          graph.weights.data(),
                          options,
                          order.data(),
                          places.data());
    }



    // Unknowns of one group follow each other. First come groups without
    // neighbours, as of unknowns that are held.
    std::vector<int>
    places_of_unknowns(const std::vector<int>   &groups,
                       const std::vector<int>   &sizes,
                       const Graph              &graph,
                       const std::vector<idx_t> &order)
    {
      std::vector<int>  next(sizes.size());
      std::vector<bool> is_vertex(sizes.size(), false);
      for (const int name : graph.names)
        is_vertex[name] = true;
      int place = 0;
      for (std::size_t name = 0; name < sizes.size(); ++name)
        if (!is_vertex[name])
        {
          next[name] = place;
          place += sizes[name];
        }
      for (const idx_t v : order)
      {
        next[graph.names[v]] = place;
        place += sizes[graph.names[v]];
      }
      std::vector<int> places(groups.size());
      for (std::size_t i = 0; i < groups.size(); ++i)
        places[i] = next[groups[i]]++;
      return places;
    }



    int
    find_places(const std::vector<int> &edges,
                const std::vector<int> &groups,
                std::vector<int>       &places)
    {
      std::vector<int> sizes(groups.size(), 0);
      for (const int group : groups)
        ++sizes[group];
      Graph              graph = make_graph(edges, sizes);
      std::vector<idx_t> order;
      const int          result = dissect(graph, order);
      if (result == METIS_OK)
        places = places_of_unknowns(groups, sizes, graph, order);
      return result;
    }



    LinearOutcome
    failure(const std::string &reason)
    {
      return {false, 0, "ordering by METIS failed: " + reason};
    }
  } // namespace



  bool
  nested_dissection_is_available()
  {
    return true;
  }



  LinearOutcome
  nested_dissection(const LinearAlgebra::SparseMatrix &matrix,
                    const MatrixSymmetry               symmetry,
                    std::vector<int>                  &positions)
  {
    positions.clear();
    const MPI_Comm          communicator = matrix.get_mpi_communicator();
    const Epetra_CrsMatrix &rows         = matrix.trilinos_matrix();
    const std::vector<int>  groups       = groups_of(rows, communicator);
    std::vector<int> edges = neighbours_of_groups(rows, groups, symmetry);
    // METIS and MPI count in int, edges in both directions
    if (2. *
          Utilities::MPI::sum(static_cast<double>(edges.size()), communicator) >
        INT_MAX)
      return failure("the matrix has too many entries");
    edges      = gathered(edges, communicator);
    int result = METIS_OK;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      result = find_places(edges, groups, positions);
    result = Utilities::MPI::broadcast(communicator, result, 0);
    if (result == METIS_ERROR_MEMORY)
      return failure("there is not enough memory");
    if (result != METIS_OK)
      return failure("error " + std::to_string(result));
    return {};
  }
} // namespace MixedCracks

#else

namespace MixedCracks
{
  bool
  nested_dissection_is_available()
  {
    return false;
  }



  LinearOutcome
  nested_dissection(const LinearAlgebra::SparseMatrix &,
                    const MatrixSymmetry,
                    std::vector<int> &positions)
  {
    positions.clear();
    return {false, 0, "this program was built without METIS"};
  }
} // namespace MixedCracks

#endif
