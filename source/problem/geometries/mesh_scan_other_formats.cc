// SPDX-License-Identifier: GPL-2.0-or-later
// Files that are no mesh for us, but that are brought as one: told by their
// first bytes, or by words near the beginning, so that the message can say what
// they are.

#include <base/text.h>

#include <problem/geometries/mesh_scan_formats.h>

#include <cstdint>
#include <cstring>

namespace MixedCracks
{
  namespace MeshScanning
  {
    namespace
    {
      struct Format
      {
        std::string beginning;
        std::string name;
      };

      // After blanks, empty lines and a byte order mark
      const std::vector<Format> by_beginning = {
        {"\x89HDF", "an HDF5 file (MED, Exodus II, CGNS or data of XDMF)"},
        {std::string("CDF"), "a netCDF file (Exodus II)"},
        {"ISO-10303-21", "a STEP file, a geometry without a mesh"},
        {"DBRep_DrawableShape", "a BREP file, a geometry without a mesh"},
        {"CASCADE Topology", "a BREP file, a geometry without a mesh"},
        {"solid", "an STL file, a surface without cells inside"},
        {"ply\n", "a PLY file, a surface without cells inside"},
        {"OFF\n", "an OFF file, a surface without cells inside"},
        {"#VRML", "a VRML file, a surface without cells inside"},
        {"#Inventor", "an Inventor file, a surface without cells inside"},
        {"<?xml", "an XML file (VTK's .vtu, XDMF, X3D)"},
        {"<VTKFile", "an XML file of VTK (.vtu)"},
        {"<Xdmf", "an XDMF file"},
        {"$NOD", "a Gmsh file of version 1"},
        {"$PostFormat", "a Gmsh file of results"},
        {"$ Created by Gmsh\nGRID", "a Nastran file (.bdf)"},
        {"$# LS-DYNA", "an LS-DYNA file (.k, .key)"},
        {"*KEYWORD", "an LS-DYNA file (.k, .key)"},
        {"MeshVersionFormatted", "a Medit file (.mesh)"},
        {"NDIME", "an SU2 file"},
        {"Finite element mesh (GridFE)", "a Diffpack file"},
        {"CONTROL INFO", "a Gambit file (.neu)"},
        {"(----Tochnog", "a Tochnog file"},
        {"%  Matlab mesh", "a Matlab file"},
        {"-1\n  2411", "an I-deas file (.unv)"},
        {"-1\n   164", "an I-deas file (.unv)"},
        {"-1\n   151", "an I-deas file (.unv)"},
        {"TITLE", "a Tecplot or Code_Aster file"},
        {"VARIABLES", "a Tecplot file"}};

      // Scripts of Gmsh
      const std::vector<std::string> words_of_scripts =
        {"SetFactory(", "Point(", "Point (", "Rectangle(", "Box(", "Disk("};



      // A head of 80 bytes, the number of triangles, 50 bytes for each
      bool
      is_binary_stl(const std::string &bytes)
      {
        std::uint32_t n_triangles = 0;
        if (bytes.size() < 84)
          return false;
        std::memcpy(&n_triangles, bytes.data() + 80, sizeof(n_triangles));
        return n_triangles > 0 && bytes.size() == 84 + 50ull * n_triangles;
      }



      // The beginning, without what does not count; of line ends only '\n'
      std::string
      beginning_of(const std::string &bytes)
      {
        std::string head = bytes.substr(0, 4000);
        if (starts_with(head, "\xEF\xBB\xBF"))
          head.erase(0, 3);
        std::string unix_head;
        for (const char c : head)
          if (c != '\r')
            unix_head += c;
        const std::size_t first = unix_head.find_first_not_of(" \t\n");
        return first == std::string::npos ? "" : unix_head.substr(first);
      }
    } // namespace



    std::string
    name_of_other_format(const std::string &bytes)
    {
      const std::string head = beginning_of(bytes);
      for (const Format &format : by_beginning)
        if (starts_with(head, format.beginning))
          return format.name;
      if (starts_with(head, "# vtk") &&
          head.find("\nBINARY") != std::string::npos)
        return "a binary VTK file; save it as ASCII";
      if (is_binary_stl(bytes))
        return "an STL file, a surface without cells inside";
      if (head.empty() || head[0] == '$' || head[0] == '*' || head[0] == '#')
        return "";
      for (const std::string &word : words_of_scripts)
        if (head.find(word) != std::string::npos)
          return "a script of Gmsh (.geo), not the mesh that Gmsh makes of it";
      return "";
    }
  } // namespace MeshScanning
} // namespace MixedCracks
