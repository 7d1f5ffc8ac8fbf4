// SPDX-License-Identifier: GPL-2.0-or-later
// Fields in XDMF and HDF5: the list is XML, the data sets have the sizes that
// it says and the values of the fields, VTU has the same values, the mesh is
// written once, and a resumed run continues the list.
#include <base/errors.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/hdf5.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/numerics/vector_tools.h>

#include <output/field_output.h>

#include <boost/property_tree/xml_parser.hpp>

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#ifdef DEAL_II_WITH_HDF5
using namespace MixedCracks;

namespace
{
  namespace fs = std::filesystem;
  using dealii::Point;
  using Tree   = boost::property_tree::ptree;
  using Matrix = dealii::FullMatrix<double>;

  template <int dim>
  double
  linear(const Point<dim> &x, const unsigned int component)
  {
    return 0.25 + 0.5 * x[0] - (0.125 + component) * x[1] + 0.1 * x[dim - 1];
  }

  bool
  is_first()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  // A box with linear fields, and a directory to write into
  template <int dim>
  class Written
  {
  public:
    Written(const std::string &name, const unsigned int n_refinements)
      : triangulation(MPI_COMM_WORLD)
      , fields(triangulation, {true, 2})
      , directory(::testing::TempDir() + "mixed_cracks_" + name)
    {
      if (is_first())
      {
        fs::remove_all(directory);
        fs::create_directories(directory + "/fields");
      }
      MPI_Barrier(MPI_COMM_WORLD);
      dealii::GridGenerator::hyper_rectangle(
        triangulation, Point<dim>(), upper_corner());
      triangulation.refine_global(n_refinements);
      fields.distribute();
    }

    static Point<dim>
    upper_corner()
    {
      Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = 1. + d;
      return corner;
    }

    void
    write(FieldOutput<dim> &output, const unsigned int step) const
    {
      State state;
      state.time        = 0.5 * step;
      state.elastic     = fields.ghosted_vector(fields.elastic_dofs);
      state.phase_field = fields.ghosted_vector(fields.phase_field_dofs);
      using Component   = std::function<double(const Point<dim> &)>;
      std::vector<Component> components;
      for (unsigned int c = 0; c <= dim; ++c)
        components.push_back([c](const Point<dim> &x) { return linear(x, c); });
      auto elastic = fields.owned_vector(fields.elastic_dofs);
      dealii::VectorTools::interpolate(
        fields.mapping,
        fields.elastic,
        dealii::FunctionFromFunctionObjects<dim>(components),
        elastic);
      auto phase_field = fields.owned_vector(fields.phase_field_dofs);
      dealii::VectorTools::interpolate(
        fields.mapping,
        fields.phase_field,
        dealii::ScalarFunctionFromFunctionObject<dim>(
          [](const Point<dim> &x) { return linear(x, 7); }),
        phase_field);
      state.elastic     = elastic;
      state.phase_field = phase_field;
      dealii::Vector<float> centers(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        centers(cell->active_cell_index()) = float(cell->center()[0]);
      output.write(state, step, {{"center", centers}});
    }

    bool
    has_file(const std::string &name) const
    {
      return fs::exists(directory + "/" + name);
    }

    // the elements <Grid> of fields.xdmf
    std::vector<Tree>
    grids() const
    {
      Tree tree;
      boost::property_tree::read_xml(directory + "/fields.xdmf", tree);
      std::vector<Tree> result;
      for (const auto &child : tree.get_child("Xdmf.Domain.Grid"))
        if (child.first == "Grid")
          result.push_back(child.second);
      return result;
    }

    // the data set of a <DataItem>, with its size compared
    Matrix
    data(const Tree &item) const
    {
      const std::string  text  = item.data();
      const auto         colon = text.find(':');
      dealii::HDF5::File file(directory + "/" + text.substr(0, colon),
                              dealii::HDF5::File::FileAccessMode::open);
      const Matrix       result =
        file.open_dataset(text.substr(colon + 2)).template read<Matrix>();
      EXPECT_EQ(item.get<std::string>("<xmlattr>.Dimensions"),
                std::to_string(result.m()) + " " + std::to_string(result.n()));
      return result;
    }

    std::map<std::string, Matrix>
    attributes(const Tree &grid) const
    {
      std::map<std::string, Matrix> result;
      for (const auto &child : grid)
        if (child.first == "Attribute")
          result[child.second.get<std::string>("<xmlattr>.Name")] =
            data(child.second.get_child("DataItem"));
      return result;
    }

    dealii::parallel::distributed::Triangulation<dim> triangulation;
    Fields<dim>                                       fields;
    const std::string                                 directory;
  };

  std::string
  mesh_of(const Tree &grid)
  {
    const std::string text = grid.get<std::string>("Geometry.DataItem");
    return text.substr(0, text.find(':'));
  }

  template <int dim>
  void
  expect_linear_fields(const Written<dim> &run, const Tree &grid)
  {
    const Matrix nodes = run.data(grid.get_child("Geometry.DataItem"));
    const Matrix cells = run.data(grid.get_child("Topology.DataItem"));
    ASSERT_EQ(cells.m(), run.triangulation.n_global_active_cells());
    ASSERT_EQ(cells.n(), dealii::GeometryInfo<dim>::vertices_per_cell);
    ASSERT_EQ(nodes.m(), cells.m() * cells.n());
    ASSERT_EQ(nodes.n(), static_cast<unsigned int>(dim));
    const auto values = run.attributes(grid);
    // deal.II keeps what is to be written in single precision; values are
    // less than 32 here
    const double tolerance = 32. * std::numeric_limits<float>::epsilon();
    for (const char *name :
         {"displacement", "pressure", "phase_field", "center", "subdomain"})
      ASSERT_EQ(values.count(name), 1u) << name;
    for (unsigned int cell = 0; cell < cells.m(); ++cell)
    {
      double center = 0.;
      for (unsigned int v = 0; v < cells.n(); ++v)
      {
        const auto node = static_cast<unsigned int>(cells(cell, v));
        ASSERT_LT(node, nodes.m());
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = nodes(node, d);
        center += x[0] / cells.n();
        EXPECT_NEAR(values.at("phase_field")(node, 0), linear(x, 7), tolerance);
        EXPECT_NEAR(values.at("pressure")(node, 0), linear(x, dim), tolerance);
        for (unsigned int d = 0; d < 3; ++d)
          EXPECT_NEAR(values.at("displacement")(node, d),
                      d < dim ? linear(x, d) : 0.,
                      tolerance);
      }
      const auto node = static_cast<unsigned int>(cells(cell, 0));
      EXPECT_NEAR(values.at("center")(node, 0), center, tolerance);
    }
  }

  // The first array of that name in a .vtu, as this program writes them: one
  // block of zlib, base64, 32 bits
  std::vector<float>
  array_of_vtu(const std::string &path, const std::string &name)
  {
    std::ifstream     file(path);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    auto begin = text.find('>', text.find("Name=\"" + name + "\"")) + 1;
    begin      = text.find_first_not_of(" \n", begin);
    const auto                       end = text.find_first_of(" \n<", begin);
    const std::vector<unsigned char> head =
      dealii::Utilities::decode_base64(text.substr(begin, 24));
    const std::vector<unsigned char> packed = dealii::Utilities::decode_base64(
      text.substr(begin + 24, end - begin - 24));
    std::uint32_t sizes[4] = {0, 0, 0, 0};
    std::memcpy(sizes, head.data(), sizeof(sizes));
    EXPECT_EQ(sizes[0], 1u);
    std::vector<float> values(sizes[1] / sizeof(float));
    uLongf             size = sizes[1];
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef *>(values.data()),
                         &size,
                         packed.data(),
                         sizes[3]),
              Z_OK);
    return values;
  }
} // namespace

template <typename Dimension>
class FieldOutputOf : public ::testing::Test
{};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>,
                                    std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FieldOutputOf, Dimensions, );



TYPED_TEST(FieldOutputOf, XdmfHoldsTheFields)
{
  constexpr int    dim = TypeParam::value;
  Written<dim>     run("xdmf", 2);
  FieldOutput<dim> output(run.fields, run.directory, "XDMF");
  run.write(output, 4);
  EXPECT_FALSE(run.has_file("fields.pvd"));
  EXPECT_EQ(output.records().front().second, "fields/fields_00004.h5");
  if (!is_first())
    return;
  const std::vector<Tree> grids = run.grids();
  ASSERT_EQ(grids.size(), 1u);
  EXPECT_EQ(grids[0].get<double>("Time.<xmlattr>.Value"), 2.);
  expect_linear_fields(run, grids[0]);
  for (const auto &entry : fs::recursive_directory_iterator(run.directory))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}



TYPED_TEST(FieldOutputOf, ARankWithoutCellsMayTakePart)
{
  constexpr int    dim = TypeParam::value;
  Written<dim>     run("one_cell", 0);
  FieldOutput<dim> output(run.fields, run.directory, "XDMF");
  run.write(output, 0);
  run.write(output, 1);
  if (is_first())
    for (const Tree &grid : run.grids())
      expect_linear_fields(run, grid);
}



TEST(FieldOutput, VtuHasTheSameValues)
{
  Written<2>     run("both", 2);
  FieldOutput<2> output(run.fields, run.directory, "both");
  run.write(output, 3);
  if (!is_first())
    return;
  ASSERT_TRUE(run.has_file("fields.pvd"));
  const auto attributes = run.attributes(run.grids().front());
  for (const std::string name : {"phase_field", "displacement", "center"})
  {
    // the pieces of the ranks one after the other
    std::vector<float> found;
    for (unsigned int rank = 0;
         run.has_file("fields/fields_00003." + std::to_string(rank) + ".vtu");
         ++rank)
    {
      const std::vector<float> piece = array_of_vtu(
        run.directory + "/fields/fields_00003." + std::to_string(rank) + ".vtu",
        name);
      found.insert(found.end(), piece.begin(), piece.end());
    }
    const Matrix &expected = attributes.at(name);
    ASSERT_EQ(found.size(), expected.m() * expected.n()) << name;
    for (unsigned int i = 0; i < found.size(); ++i)
      EXPECT_EQ(found[i], float(expected(i / expected.n(), i % expected.n())))
        << name << " " << i;
  }
}



TEST(FieldOutput, AMeshIsWrittenOnceAndAResumedListContinued)
{
  Written<2>     run("resumed", 1);
  FieldOutput<2> output(run.fields, run.directory, "XDMF");
  run.write(output, 0);
  run.write(output, 2);
  const auto records = output.records(); // of a checkpoint here
  run.triangulation.refine_global();
  run.fields.distribute();
  run.write(output, 3);
  MPI_Barrier(MPI_COMM_WORLD);
  if (is_first())
  {
    const std::vector<Tree> grids = run.grids();
    ASSERT_EQ(grids.size(), 3u);
    EXPECT_EQ(mesh_of(grids[0]), "fields/mesh_00000.h5");
    EXPECT_EQ(mesh_of(grids[1]), "fields/mesh_00000.h5");
    EXPECT_EQ(mesh_of(grids[2]), "fields/mesh_00003.h5");
    EXPECT_FALSE(run.has_file("fields/mesh_00002.h5"));
    expect_linear_fields(run, grids[2]);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  FieldOutput<2> resumed(run.fields, run.directory, "XDMF");
  resumed.restore(records);
  EXPECT_TRUE(resumed.has(2));
  EXPECT_FALSE(resumed.has(3));
  run.write(resumed, 5);
  if (is_first())
  {
    const std::vector<Tree> grids = run.grids();
    ASSERT_EQ(grids.size(), 3u);
    EXPECT_EQ(grids[1].get<double>("Time.<xmlattr>.Value"), 1.);
    EXPECT_EQ(grids[2].get<double>("Time.<xmlattr>.Value"), 2.5);
    EXPECT_EQ(mesh_of(grids[1]), "fields/mesh_00000.h5");
    EXPECT_EQ(mesh_of(grids[2]), "fields/mesh_00005.h5");
    expect_linear_fields(run, grids[2]);
  }
}



// From there on names have more digits.
TEST(FieldOutput, AResumedRunKnowsStep100000)
{
  Written<2> run("many_steps", 1);
  for (const std::string format : {"VTU", "XDMF"})
  {
    FieldOutput<2> output(run.fields, run.directory, format);
    run.write(output, 100000);
    FieldOutput<2> resumed(run.fields, run.directory, format);
    resumed.restore(output.records());
    EXPECT_TRUE(resumed.has(100000)) << format;
    EXPECT_FALSE(resumed.has(10000)) << format;
  }
}



TEST(FieldOutput, NoneIsWritten)
{
  Written<2>     run("none", 1);
  FieldOutput<2> output(run.fields, run.directory, "none");
  EXPECT_FALSE(output.is_on());
  run.write(output, 0);
  run.write(output, 3);
  EXPECT_TRUE(output.records().empty());
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(fs::is_empty(run.directory + "/fields"));
  EXPECT_FALSE(run.has_file("fields.pvd") || run.has_file("fields.xdmf"));
}



TEST(FieldOutput, AStepThatIsLeftOutIsNotWritten)
{
  Written<2>     run("left_out", 1);
  FieldOutput<2> output(run.fields, run.directory, "VTU");
  EXPECT_TRUE(output.is_on());
  output.leave_out(2);
  run.write(output, 2);
  EXPECT_TRUE(output.records().empty());
  run.write(output, 3);
  EXPECT_EQ(output.records().size(), 1u);
}



TEST(FieldOutput, WhatCannotBeWrittenIsAFileErrorOnAllRanks)
{
  Written<2> run("unwritable", 1);
  MPI_Barrier(MPI_COMM_WORLD);
  if (is_first())
    fs::remove_all(run.directory);
  MPI_Barrier(MPI_COMM_WORLD);
  for (const std::string format : {"VTU", "XDMF"})
  {
    FieldOutput<2> output(run.fields, run.directory, format);
    EXPECT_THROW(run.write(output, 0), FileError) << format;
  }
}
#endif
