#pragma once
// One declaration of a keyword serves reading, checking and documentation.
//
// A struct of options lists its entries once:
//
//     struct Convergence {
//         double tolU = 1e-4;
//         int maxIterations = 40;
//         template <class Visitor>
//         void entries(Visitor& v) {
//             v("tolU", tolU, "-", "relative change of velocity at which the iteration stops", positive);
//             v("maxIterations", maxIterations, "-", "iterations before the step is rejected", atLeast(1));
//         }
//     };
//
// The member's initial value is the documented default. `readEntries(dict, options)` reads what is there;
// `describeEntries<Convergence>()` gives the rows of the keyword reference.
