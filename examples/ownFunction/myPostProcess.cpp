// pfemPostProcess with the function objects of this project beside those of the library.

#include <iostream>

#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "functions/postProcess.hpp"

using namespace pfem;

int main(int argc, char** argv) {
    OptionsSpec spec;
    spec.addTimeSelection().add("func", "name", "The entry of `functions` in system/controlDict");
    return runApplication(
        argc, argv, "Function objects over the written times.", spec, [](const Options& options) {
            const Case theCase = options.openCase();
            const auto times = selectTimes(theCase, options);
            const Dictionary dict = Dictionary::read(theCase.controlDict());
            FunctionObjects<2> functions(theCase, dict, times.front().name, 6, [&](const Dictionary& entry) {
                return !options.found("func") || entry.keyword() == options.get("func");
            });
            postProcess(theCase, functions, times, true, std::cout);
            return 0;
        });
}
