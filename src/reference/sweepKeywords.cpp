#include "reference/keywords.hpp"
#include "study/sweep.hpp"

namespace pfem {

std::vector<KeywordTable> sweepKeywords() {
    const std::string file = "system/sweepDict";
    return {
        {file, "", "A study by `pfemSweep`; two of its sub-dictionaries follow.", describeEntries<SweepEntries>()},
        {file, "parameters", "One dictionary for each entry that changes, under the name of its column in the table.",
         describeParameter()},
        {file, "results", "One dictionary for each number that is gathered, under the name of its column in the table.",
         describeEntries<ResultEntries>()},
    };
}

}  // namespace pfem
