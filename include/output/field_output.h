// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mixed_cracks_output_field_output_h
#define mixed_cracks_output_field_output_h

#include <deal.II/lac/vector.h>

#include <discretization/fields.h>
#include <discretization/state.h>

#include <output/xdmf_output.h>

#include <boost/signals2/connection.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace MixedCracks
{
  /// fields.pvd and fields/*.pvtu, or fields.xdmf and fields/*.h5, or all of
  /// them, for ParaView; in 3-d crack_surface.pvd as well.
  template <int dim>
  class FieldOutput
  {
  public:
    /// @p directory: the output directory, with "fields" in it unless nothing
    /// is written. @p format: "VTU", "XDMF", "both" or "none".
    FieldOutput(const Fields<dim> &fields,
                const std::string &directory,
                const std::string &format = "VTU");

    /// Whether write() writes anything.
    bool
    is_on() const
    {
      return writes_vtu || writes_xdmf;
    }

    /// Write @p state as step @p step unless that step is written already.
    /// @p cell_data: further values per active cell, by name. Throws
    /// FileError. Collective.
    void write(const State                                        &state,
               unsigned int                                        step,
               const std::map<std::string, dealii::Vector<float>> &cell_data);

    bool
    has(const unsigned int step) const
    {
      return steps.count(step) > 0;
    }

    /// Never write @p step: its state is gone.
    void
    leave_out(const unsigned int step)
    {
      steps.insert(step);
    }

    /// Continue the list of a resumed run.
    void restore(const std::vector<std::pair<double, std::string>> &earlier);

    const std::vector<std::pair<double, std::string>> &
    records() const
    {
      return times_and_names;
    }

  private:
    /// Returns the name of the file to be kept in the records.
    std::string write_vtu(const dealii::DataOut<dim> &data_out,
                          unsigned int                step) const;

    /// Record them before they are written; false when that fails.
    bool note_vtu_files(unsigned int step) const;

    void write_collection() const;

    /// In 3-d: the surface of the cracks, for the step written last.
    void write_surface(const LinearAlgebra::Vector &phase_field) const;

    const Fields<dim>                          &fields;
    const std::string                           directory;
    const bool                                  writes_vtu;
    const bool                                  writes_xdmf;
    XdmfOutput<dim>                             xdmf;
    boost::signals2::scoped_connection          mesh_watch;
    std::set<unsigned int>                      steps;
    std::vector<std::pair<double, std::string>> times_and_names;
  };
} // namespace MixedCracks

#endif
