// SPDX-License-Identifier: GPL-2.0-or-later
#include <base/collective.h>

#include <deal.II/base/mpi.h>

#include <output/disk.h>
#include <output/run_directory.h>
#include <output/small_file.h>

namespace MixedCracks
{
  namespace
  {
    // bytes: the header of statistics.csv, points of the user's own included
    constexpr std::uint64_t room_for_first_rows = 4096;
  } // namespace



  bool
  RunDirectory::inspect(const ExistingRun               existing,
                        const std::vector<std::string> &to_be_written)
  {
    waiting = existing;
    names   = to_be_written;
    return inspect_output_directory(directory, existing, names, communicator);
  }



  bool
  RunDirectory::open()
  {
    if (!waiting)
      return false;
    const ExistingRun existing = *waiting;
    waiting.reset();
    prepare_output_directory(directory,
                             existing,
                             names,
                             {{"parameters.prm", effective_parameters.size()},
                              {"log.txt", log.size_until_open()},
                              {"statistics.csv", room_for_first_rows}},
                             communicator);
    log.open(directory + "/log.txt", existing == ExistingRun::resume);
    throw_on_all_ranks(log.failure(), communicator);
    on_first_rank(communicator, [&]() {
      // a resumed run had them already
      if (!write_durably(directory + "/parameters.prm", effective_parameters)
             .empty())
        throw FileError("Output/Directory: '" + directory +
                        "/parameters.prm' cannot be written.");
    });
    return true;
  }



  std::vector<std::string>
  files_of_run(const int               dim,
               const OutputParameters &parameters,
               const bool              with_crack_openings)
  {
    const std::string        format = parameters.field_format;
    std::vector<std::string> names  = {"log.txt",
                                       "statistics.csv",
                                       "parameters.prm",
                                       "parameters.prm.part",
                                       "summary.json",
                                       "summary.json.part",
                                       "checkpoint/",
                                       "checkpoint/generation-0/",
                                       "checkpoint/generation-1/"};
    const auto               add = [&names](const bool                      is_written,
                              const std::vector<std::string> &more) {
      if (is_written)
        names.insert(names.end(), more.begin(), more.end());
    };
    add(dim == 2,
        {"crack_path.csv",
         "crack_path.csv.part",
         "crack_path.pvd",
         "crack_path.pvd.part",
         "crack_path/"});
    for (const std::string name : {"crack_sheet", "crack_front"})
      add(dim == 3,
          {name + ".csv",
           name + ".csv.part",
           name + ".pvd",
           name + ".pvd.part",
           name + '/'});
    add(with_crack_openings, {"crack_opening.csv", "crack_opening.csv.part"});
    add(parameters.with_fields(), {"fields/"});
    add(format == "VTU" || format == "both", {"fields.pvd", "fields.pvd.part"});
    add(format == "XDMF" || format == "both",
        {"fields.xdmf", "fields.xdmf.part"});
    add(dim == 3 && parameters.with_fields(),
        {"crack_surface.pvd", "crack_surface.pvd.part"});
    return names;
  }
} // namespace MixedCracks
