#include "io/gridFile.hpp"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkXMLWriter.h>
#include <vtkZLibDataCompressor.h>

#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "base/atomicFile.hpp"
#include "base/error.hpp"
#include "io/gridCheck.hpp"

namespace pfem {

namespace {

/// "ERROR: In file.cxx, line 7\nvtkReader (0x55): Cannot read ...\n\n" without what concerns VTK's sources alone.
std::string plainText(std::string message) {
    if (const auto begin = message.find("): "); begin != std::string::npos) message.erase(0, begin + 3);
    return message.substr(0, message.find('\n'));
}

/// Keeps the first messages that VTK sends to observers: the cause, then where it was met.
class FirstErrors : public vtkCommand {
public:
    static FirstErrors* New() { return new FirstErrors; }
    void Execute(vtkObject*, unsigned long, void* data) override { add(static_cast<const char*>(data)); }
    void add(const char* text) {
        const std::string plain = text != nullptr ? plainText(text) : "unknown error";
        if (message_.size() < 300 && message_.find(plain) == std::string::npos)
            message_ += (message_.empty() ? "" : " ") + plain;
    }
    const std::string& message() const { return message_; }

private:
    std::string message_;
};

/// What VTK would print on stderr, collected instead.
class SilentWindow : public vtkOutputWindow {
public:
    static SilentWindow* New();
    vtkTypeMacro(SilentWindow, vtkOutputWindow) void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override { error_->add(text); }
    void DisplayWarningText(const char*) override {}
    void DisplayGenericWarningText(const char*) override {}
    void DisplayDebugText(const char*) override {}
    vtkSmartPointer<FirstErrors> error_;
};
vtkStandardNewMacro(SilentWindow)

    /// VTK is silent while this lives; its first errors can be asked for.
    class VtkErrors {
public:
    VtkErrors() : previous_(vtkOutputWindow::GetInstance()) {
        auto window = vtkSmartPointer<SilentWindow>::New();
        window->error_ = error_;
        vtkOutputWindow::SetInstance(window);
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    }
    ~VtkErrors() {
        vtkOutputWindow::SetInstance(previous_);
        vtkLogger::SetStderrVerbosity(verbosity_);
    }
    VtkErrors(const VtkErrors&) = delete;
    VtkErrors& operator=(const VtkErrors&) = delete;

    vtkCommand* observer() { return error_; }
    const std::string& message() const { return error_->message(); }

private:
    vtkSmartPointer<FirstErrors> error_ = vtkSmartPointer<FirstErrors>::New();
    vtkSmartPointer<vtkOutputWindow> previous_;
    vtkLogger::Verbosity verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
};

[[noreturn]] void fail(const std::string& what, const std::filesystem::path& file, const std::string& reason) {
    throw UserError(what + " \"" + file.string() + "\": " + reason, {file.string(), 0});
}

/// VTK's error codes begin with the system's.
std::string reasonOf(unsigned long code) {
    if (code == vtkErrorCode::OutOfDiskSpaceError) return "no space left on the disk";
    if (code < vtkErrorCode::FirstVTKErrorCode) return std::strerror(static_cast<int>(code));
    return "write error " + std::to_string(code);
}

/// With a writer of VTK's XML files.
void writeData(const std::filesystem::path& file, vtkXMLWriter* writer, vtkDataObject* data) {
    VtkErrors errors;
    writer->AddObserver(vtkCommand::ErrorEvent, errors.observer());
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    writer->SetCompressionLevel(1);
    writer->SetByteOrderToLittleEndian();
    writer->SetHeaderTypeToUInt64();
    const int written = writer->Write();
    if (const unsigned long code = writer->GetErrorCode(); code != vtkErrorCode::NoError)
        fail("cannot write", file, reasonOf(code));
    if (written != 1 || !errors.message().empty())
        fail("cannot write", file, errors.message().empty() ? "write error" : errors.message());
}

/// "array 'p' is ": the first one that cannot be decompressed or has a wrong number of strings; "" when all are sound,
/// and for files of others.
std::string whereBroken(const std::filesystem::path& file, bool onlyStrings) {
    const std::string text = readText(file);
    if (!damageOf(text).reason.empty()) return "";
    const vtkNew<vtkZLibDataCompressor> zlib;
    const auto unpack = [&](const char* bytes, std::size_t n, std::size_t whole) -> std::optional<std::string> {
        std::string room(whole, '\0');
        auto* const to = reinterpret_cast<unsigned char*>(room.data());
        if (zlib->Uncompress(reinterpret_cast<const unsigned char*>(bytes), n, to, whole) != whole) return {};
        return room;
    };
    const std::string array = brokenArray(text, unpack, onlyStrings);
    return array.empty() ? "" : "array '" + array + "' is ";
}

/// With a reader of VTK's XML files; there are points.
template <class Data, class Reader>
vtkSmartPointer<Data> readData(const std::filesystem::path& file, const vtkNew<Reader>& reader) {
    VtkErrors errors;
    reader->AddObserver(vtkCommand::ErrorEvent, errors.observer());
    reader->SetReaderErrorObserver(errors.observer());
    reader->SetParserErrorObserver(errors.observer());
    reader->SetFileName(file.c_str());
    try {
        reader->Update();
    } catch (const std::exception& error) {  // sizes that no memory can hold
        fail("cannot read", file, std::string("truncated or corrupt (") + error.what() + ")");
    }
    if (!errors.message().empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
        fail("cannot read", file, whereBroken(file, false) + "truncated or corrupt (" + errors.message() + ")");
    Data* data = reader->GetOutput();
    if (data == nullptr || data->GetPoints() == nullptr) fail("cannot read", file, "array 'Points' is missing");
    return data;
}

}  // namespace

void writeGrid(const std::filesystem::path& file, vtkUnstructuredGrid* grid) {
    writeData(file, vtkNew<vtkXMLUnstructuredGridWriter>(), grid);
}

void writePolyData(const std::filesystem::path& file, vtkPolyData* surface) {
    writeData(file, vtkNew<vtkXMLPolyDataWriter>(), surface);
}

vtkSmartPointer<vtkUnstructuredGrid> readGrid(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file))
        throw UserError("cannot find file \"" + file.string() + "\"", {file.string(), 0});
    if (const auto array = whereBroken(file, true); !array.empty())  // too many strings: VTK writes behind its memory
        fail("cannot read", file, array + "truncated or corrupt");
    auto grid = readData<vtkUnstructuredGrid>(file, vtkNew<vtkXMLUnstructuredGridReader>());
    if (vtkCellArray* cells = grid->GetCells(); cells != nullptr)
        if (!cells->IsValid() || cells->GetNumberOfCells() != grid->GetNumberOfCells() ||
            (grid->GetNumberOfCells() > 0 &&
             (grid->GetCellTypesArray() == nullptr ||
              grid->GetCellTypesArray()->GetNumberOfValues() != grid->GetNumberOfCells())))
            fail("cannot read", file, "arrays 'offsets', 'connectivity' and 'types' contradict each other");
    return grid;
}

vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& file) {
    return readData<vtkPolyData>(file, vtkNew<vtkXMLPolyDataReader>());
}

}  // namespace pfem
