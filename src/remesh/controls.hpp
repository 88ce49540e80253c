#pragma once
// What a user may set of the remeshing, in system/pfemSolution.

#include "dictionary/entries.hpp"
#include "walls/controls.hpp"

namespace pfem {

/// Sub-dictionary `remeshing/expert`: each of them times 0.7 and 1.4 changes results by no more than 3 % of the mesh
/// size does (doc/decisions.md).
struct ExpertRemeshing {
    double alpha = 1.3;
    double alphaInside = 1.75;
    double newContactRadius = 0.9;
    double sliver = 1e-3;
    double hangingArea = 0.05;
    double removeDistanceFilm = 0.25;
    double removeHeight = 0.3;
    WallDistances walls;

    template <class Visitor>
    void entries(Visitor& v) {
        v("alpha", alpha, "-", "alpha shape: largest circumradius / h of a triangle that is fluid", positive);
        v("alphaInside", alphaInside, "-", "factor on alpha inside the fluid of the step before", atLeast(1.0));
        v("newContactRadius", newContactRadius, "-", "largest circumradius / h of a new contact", positive);
        v("sliver", sliver, "-", "area / h^2 below which a triangle at the surface is dropped", nonNegative);
        v("hangingArea", hangingArea, "-",
          "area / h^2 of a triangle below which the only node that it carries flies off as a drop; also when the "
          "triangle would lose half of its area within a step",
          nonNegative);
        v("removeDistanceFilm", removeDistanceFilm, "-",
          "distance / h at which a free-surface node is removed that comes near to one across a film with two free "
          "sides, or at the "
          "end of one; not above removeDistanceSurface",
          nonNegative);
        v("removeHeight", removeHeight, "-",
          "height / h over a face of the free surface below which a node inside the fluid is removed: flat triangles "
          "there hold "
          "up the time step and the iteration",
          nonNegative);
        walls.entries(v);
    }
};

/// Sub-dictionary `remeshing`.
struct RemeshingControls {
    double contactHeight = 0.3;
    double wallContactHeight = 0.5;
    double removeDistance = 0.6;
    double removeDistanceSurface = 0.4;
    double insertDistance = 1.7;
    WallControls walls;
    ExpertRemeshing expert;
    bool keepSurface = true;
    double distortion = 0;
    double surfaceShift = 0.05;
    bool letGo = true;
    bool keepMomentum = false;

    template <class Visitor>
    void entries(Visitor& v) {
        v("contactHeight", contactHeight, "-", "height / h at which two free surfaces touch", positive);
        v("wallContactHeight", wallContactHeight, "-", "height / h at which fluid touches a dry wall or solid",
          positive);
        v("removeDistance", removeDistance, "-", "distance / h at which an inner node is removed", nonNegative);
        v("removeDistanceSurface", removeDistanceSurface, "-", "distance / h at which a free-surface node is removed",
          nonNegative);
        v("insertDistance", insertDistance, "-", "edge / h above which a node is inserted", positive);
        walls.entries(v);
        v("keepSurface", keepSurface, "-",
          "the moved free surface constrains the triangulation: only contacts and breaks change the volume", any);
        v("surfaceShift", surfaceShift, "-",
          "distance / h that a free-surface node may shift in a step to make up for volume that was lost or gained "
          "around "
          "it; 0 = none",
          nonNegative);
        v("letGo", letGo, "-",
          "a drop goes when it has left the box of walls, solids and the rest of the fluid and can never come back "
          "(under a gravity that "
          "stays as it is); its volume is the ledger's cause gone",
          any);
        v("keepMomentum", keepMomentum, "-",
          "regions of triangles that are meshed anew keep their mean velocity: nodes that go take no momentum along",
          any);
        v("distortion", distortion, "-",
          "remesh when the least quality of a fluid triangle falls below this; 0 = every step", nonNegative);
    }
};

}  // namespace pfem
