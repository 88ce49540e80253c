#include "io/pngFile.hpp"

#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "base/atomicFile.hpp"
#include "base/error.hpp"

namespace pfem {

void writePng(const std::filesystem::path& file, const Image& image) {
    auto data = vtkSmartPointer<vtkImageData>::New();
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < image.height; ++y) {
        auto* row = static_cast<unsigned char*>(data->GetScalarPointer(0, image.height - 1 - y, 0));  // VTK: upwards
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) *row++ = image.at(x, y)[c];
    }
    auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->WriteToMemoryOn();
    writer->SetInputData(data);
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (bytes == nullptr || bytes->GetNumberOfValues() == 0)
        throw UserError("cannot make a PNG of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                        " pixels");
    writeAtomically(file, std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                                      static_cast<std::size_t>(bytes->GetNumberOfValues())));
}

}  // namespace pfem
