// Time folders -> one picture: fluid and solids coloured by a field, several times side by side.

#include <fmt/format.h>

#include "application/dimension.hpp"
#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/atomicFile.hpp"
#include "io/stateFiles.hpp"
#include "picture/colourMap.hpp"
#include "picture/sheet.hpp"
#include "picture/spaceOptions.hpp"

using namespace pfem;

namespace {

OptionsSpec snapshotOptions() {
    OptionsSpec spec;
    spec.addTimeSelection();
    spec.add("field", "name",
             fmt::format("Colour by {} (default p; in space vonMises, or U without solids)",
                         fmt::join(pictureFieldNames<3>(), ", ")));
    spec.add("range", "'(low high)'", "Values at the ends of the colour bar (default: of the selected times)");
    spec.add("box", "'((x y) (x y))'", "Lower left and upper right corner of what is shown [m]; in space with z");
    spec.add("colours", "name", fmt::format("Colour map: {} (default viridis)", fmt::join(ColourMap::names(), ", ")));
    spec.add("columns", "n", "Pictures side by side (default 3)");
    spec.add("width", "pixels", "Width of the whole picture (default 1600)");
    spec.add("mesh", "", "Draw the edges of the triangles");
    addSpaceOptions(spec);
    spec.add("format", "word",
             fmt::format("{} (default: as the file's name ends, or png)", fmt::join(pictureFormats(), ", ")));
    return spec.add("o", "file", "The picture (default snapshots.<format> in the case)");
}

PictureFormat formatOf(const Options& options) {
    if (options.found("format")) return pictureFormat(options.get("format"));
    const std::string ending = options.found("o") ? std::filesystem::path(options.get("o")).extension().string() : "";
    for (const auto& word : pictureFormats())
        if (ending == "." + word) return pictureFormat(word);
    return PictureFormat::png;
}

Window windowOf(const Options& options) {
    const auto corners = optionValue<std::vector<std::vector<double>>>(options, "box", "'((x y) (x y))'");
    const bool complete = corners.size() == 2 && corners[0].size() >= 2 && corners[1].size() >= 2;
    if (!complete || !(corners[0][0] < corners[1][0]) || !(corners[0][1] < corners[1][1]))
        throw UserError("-box needs the lower left and the upper right corner: '((x y) (x y))'");
    return Window{{corners[0][0], corners[0][1]}, {corners[1][0], corners[1][1]}};
}

template <int Dim>
SheetOptions sheetOptions(const Case& theCase, const Options& options) {
    SheetOptions sheet;
    if (options.found("field")) sheet.field = options.get("field");
    sheet.colours = options.get("colours", sheet.colours);
    sheet.columns = wholeNumber(options, "columns", sheet.columns, 1, 100);
    sheet.width = wholeNumber(options, "width", sheet.width, 100, 20000);
    sheet.mesh = options.found("mesh");
    sheet.format = formatOf(options);
    if (options.found("range")) {
        const auto ends = optionValue<std::vector<double>>(options, "range", "'(low high)'");
        if (ends.size() != 2 || !(ends[0] < ends[1]))
            throw UserError("-range needs two ascending numbers: '(low high)'");
        sheet.range = ValueRange{ends[0], ends[1]};
    }
    if constexpr (Dim == 3) {
        sheet.space = spaceOptions(theCase, options);
    } else {
        refuseSpaceOptions(options);
        if (options.found("box")) sheet.window = windowOf(options);
    }
    return sheet;
}

/// Draws the picture and says what was written.
template <int Dim>
int draw(const Case& theCase, const Options& options, const std::vector<TimeFolder>& times) {
    const SheetOptions sheet = sheetOptions<Dim>(theCase, options);
    std::vector<State<Dim>> states;
    for (const auto& time : times) states.push_back(readState<Dim>(theCase.time(time.name)));
    Canvas canvas = drawSheet(states, sheet);
    const auto file = options.found("o")
                          ? std::filesystem::path(options.get("o"))
                          : theCase.root() / ("snapshots." + pictureFormats()[static_cast<int>(sheet.format)]);
    writeAtomically(file, canvas.file());
    fmt::print("{} times, {} x {} pixels: {}\n", states.size(), canvas.width(), canvas.height(), file.string());
    return 0;
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(argc, argv, "Draw time folders as a picture (PNG, SVG, PDF), without ParaView or a display.",
                          snapshotOptions(), [](const Options& options) {
                              const Case theCase = options.openCase();
                              const auto times = selectTimes(theCase, options);
                              return withDimension(theCase.time(times.front().name), [&](auto dim) {
                                  return draw<decltype(dim)::value>(theCase, options, times);
                              });
                          });
}
