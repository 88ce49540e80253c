#include "functions/postProcess.hpp"

#include <ostream>

#include "base/error.hpp"
#include "io/stateFiles.hpp"

namespace pfem {

template <int Dim>
void postProcess(const Case& theCase, FunctionObjects<Dim>& functions, const std::vector<TimeFolder>& times,
                 bool overwrite, std::ostream& out) {
    for (const auto& name : functions.names()) {
        const auto folder = theCase.postProcessing(name, times.front().name);
        if (!overwrite && std::filesystem::exists(folder))
            throw UserError("\"" + folder.string() + "\" is already there: use -overwrite to replace it");
    }
    functions.prepare(readState<Dim>(theCase.time(times.front().name)));
    for (const auto& time : times) {
        out << "Time = " << time.name << std::endl;
        functions.executeAll(readState<Dim>(theCase.time(time.name)));
    }
}

#define PFEM_INSTANTIATE(D) \
    template void postProcess<D>(const Case&, FunctionObjects<D>&, const std::vector<TimeFolder>&, bool, std::ostream&);
PFEM_INSTANTIATE(2)
PFEM_INSTANTIATE(3)

}  // namespace pfem
