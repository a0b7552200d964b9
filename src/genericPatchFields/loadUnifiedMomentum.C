/*---------------------------------------------------------------------------*\
  umfsiFoam: fluid-structure interaction with one momentum equation
-------------------------------------------------------------------------------
License
    This file is part of umfsiFoam.

    umfsiFoam is free software: you can redistribute it and/or modify it
    under the terms of the GNU General Public License as published by
    the Free Software Foundation, either version 3 of the License, or
    (at your option) any later version.

    umfsiFoam is distributed in the hope that it will be useful, but WITHOUT
    ANY WARRANTY; without even the implied warranty of MERCHANTABILITY or
    FITNESS FOR A PARTICULAR PURPOSE.  See the GNU General Public License
    for more details.

    You should have received a copy of the GNU General Public License
    along with umfsiFoam.  If not, see <http://www.gnu.org/licenses/>.

Description
    Makes OpenFOAM's utilities know the patch conditions of umfsiFoam without
    an entry libs in controlDict.

    decomposePar, foamToVTK, mapFields and all others that read fields with any
    conditions are linked to OpenFOAM's library genericPatchFields. A condition
    that they do not know is read with its value only, and a missing value
    stops them. This library has the same name and comes first in
    LD_LIBRARY_PATH (etc/bashrc). It loads OpenFOAM's, which it stands before,
    and the library unifiedMomentum, which it is linked to.

\*---------------------------------------------------------------------------*/

#include <dlfcn.h>
#include <iostream>
#include <link.h>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- Takes the folder of libOpenFOAM, stops the search if this is it
    int takeFolder(dl_phdr_info* info, std::size_t, void* folder)
    {
        const std::string path(info->dlpi_name);
        const std::size_t slash = path.rfind('/');

        if
        (
            slash == std::string::npos
         || path.compare(slash, std::string::npos, "/libOpenFOAM.so") != 0
        )
        {
            return 0;
        }

        *static_cast<std::string*>(folder) = path.substr(0, slash);
        return 1;
    }


    //- Load OpenFOAM's library of the same name
    bool loadOpenFOAMs()
    {
        std::string folder;
        dl_iterate_phdr(takeFolder, &folder);

        const std::string library(folder + "/libgenericPatchFields.so");
        if (dlopen(library.c_str(), RTLD_LAZY | RTLD_GLOBAL))
        {
            return true;
        }

        std::cerr
            << "umfsiFoam: " << dlerror() << std::endl
            << "    Patch conditions that nobody knows stop this program"
            << std::endl;
        return false;
    }


    const bool loaded = loadOpenFOAMs();
}


// ************************************************************************* //
