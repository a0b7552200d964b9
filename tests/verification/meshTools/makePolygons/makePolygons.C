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


Application
    makePolygons

Description
    Replaces a two-dimensional mesh by the dual of its triangles, a polygon
    around each point: the mesh becomes one of polygonal prisms. Quadrangles
    are split into triangles first. Patches and cell zones are kept; polygons
    end at the edges of both.

Usage
    \b makePolygons [OPTION]

      - \par -diagonals \<word\>
        random (default), alternating, parallel or crossed

      - \par -seed \<label\>
        Of the random diagonals, default 1

\*---------------------------------------------------------------------------*/

#include "convertMesh.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    return Foam::convertMesh
    (
        argc,
        argv,
        "Replace a two-dimensional mesh by the dual of its triangles",
        true
    );
}


// ************************************************************************* //
