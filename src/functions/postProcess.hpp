#pragma once
// Function objects over time folders, after the run.

#include <iosfwd>

#include "case/timeFolders.hpp"
#include "functions/functionObjects.hpp"

namespace pfem {

/// Every function writes a row for each of `times`, into postProcessing/<name>/<first time>/. Tables of the
/// run itself are denser than the written times: throws UserError when a function has some there already,
/// unless `overwrite`. What sums or filters over time sees the written times only.
template <int Dim>
void postProcess(const Case& theCase, FunctionObjects<Dim>& functions, const std::vector<TimeFolder>& times,
                 bool overwrite, std::ostream& out);

}  // namespace pfem
