#!/bin/sh
# A plate of gent under prandtlEyring between rough walls, with the function fastVolume: all that the guide adds.
# Arguments: the project's folder, the folder of its programs, the solver to run, a folder for the case.
PATH="$2:$PATH"
case=$4
rm -rf "$case"
"$1/tests/tools/copyTutorial" "$1/tutorials/hydrostaticPlate" "$case" && cd "$case" || exit 1
cat > constant/materials << 'END'
water { type prandtlEyring; rho 1000; mu0 10; lambda 0.1; kappa 2.1e9; }
aluminium { type gent; rho 2700; mu 25e7; Jm 50; nu 0.34; }
END
cat > constant/boundaryConditions << 'END'
left { type rough; }
right { type rough; }
ends { type clamped; }
END
cat > system/controlDict << 'END'
endTime 0.01;
deltaT 1e-3;
adjustTimeStep no;
functions { fast { type fastVolume; speed 1e-9; } }
END
{ pfemMesh -h 0.1 && "$3"; } > log 2>&1 || { tail -n 20 log; exit 1; }
# 2 m2 of water, all of it moving but what sticks in corners
awk '!/^#/ { rows++; volume = $2 } END { if (rows < 10 || volume < 1.9 || volume > 2.01) { print rows, volume; exit 1 } }' \
    postProcessing/fast/0/fastVolume.dat
