// Time folders -> one picture: fluid and solids coloured by a field, several times side by side.

#include <fmt/format.h>

#include "application/optionValues.hpp"
#include "application/runApplication.hpp"
#include "application/timeRanges.hpp"
#include "base/atomicFile.hpp"
#include "io/stateFiles.hpp"
#include "picture/colourMap.hpp"
#include "picture/sheet.hpp"

using namespace pfem;

namespace {

OptionsSpec snapshotOptions() {
    OptionsSpec spec;
    spec.addTimeSelection();
    spec.add("field", "name", fmt::format("Colour by {} (default p)", fmt::join(pictureFieldNames(), ", ")));
    spec.add("range", "'(low high)'", "Values at the ends of the colour bar (default: of the selected times)");
    spec.add("box", "'((x y) (x y))'", "Lower left and upper right corner of what is shown [m]");
    spec.add("colours", "name", fmt::format("Colour map: {} (default viridis)", fmt::join(ColourMap::names(), ", ")));
    spec.add("columns", "n", "Pictures side by side (default 3)");
    spec.add("width", "pixels", "Width of the whole picture (default 1600)");
    spec.add("mesh", "", "Draw the edges of the triangles");
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

SheetOptions sheetOptions(const Options& options) {
    SheetOptions sheet;
    sheet.field = pictureField(options.get("field", sheet.field)).name;
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
    if (options.found("box")) {
        const auto corners = optionValue<std::vector<std::vector<double>>>(options, "box", "'((x y) (x y))'");
        const bool complete = corners.size() == 2 && corners[0].size() >= 2 && corners[1].size() >= 2;
        if (!complete || !(corners[0][0] < corners[1][0]) || !(corners[0][1] < corners[1][1]))
            throw UserError("-box needs the lower left and the upper right corner: '((x y) (x y))'");
        sheet.window = Window{{corners[0][0], corners[0][1]}, {corners[1][0], corners[1][1]}};
    }
    return sheet;
}

}  // namespace

int main(int argc, char* argv[]) {
    return runApplication(
        argc, argv, "Draw time folders as a picture (PNG, SVG, PDF), without ParaView or a display.", snapshotOptions(),
        [](const Options& options) {
            const Case theCase = options.openCase();
            const SheetOptions sheet = sheetOptions(options);
            std::vector<State<2>> states;
            for (const auto& time : selectTimes(theCase, options))
                states.push_back(readState<2>(theCase.time(time.name)));
            Canvas canvas = drawSheet(states, sheet);
            const auto file = options.found("o")
                                  ? std::filesystem::path(options.get("o"))
                                  : theCase.root() / ("snapshots." + pictureFormats()[static_cast<int>(sheet.format)]);
            writeAtomically(file, canvas.file());
            fmt::print("{} times, {} x {} pixels: {}\n", states.size(), canvas.width(), canvas.height(), file.string());
            return 0;
        });
}
