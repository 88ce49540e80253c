#pragma once
// Typed arrays of a grid: made when writing, checked when reading. Internal to src/io.

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/types.hpp"

namespace pfem {

/// A new array of n tuples; `value(i, c)` gives component c of tuple i.
template <class Array, class Value>
vtkSmartPointer<Array> makeArray(const std::string& name, int components, int n, const Value& value) {
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(n);
    for (int i = 0; i < n; ++i)
        for (int c = 0; c < components; ++c)
            array->SetTypedComponent(i, c, static_cast<typename Array::ValueType>(value(i, c)));
    return array;
}

/// `words` as an array of strings.
vtkSmartPointer<vtkStringArray> makeWords(const std::string& name, const std::vector<std::string>& words);

/// Readers of one file's arrays. Every method throws UserError naming the file when the array is absent,
/// has another type, another number of components or tuples, or (doubles) values that are not finite.
class CheckedArrays {
public:
    CheckedArrays(std::filesystem::path file, vtkFieldData* data, vtkIdType tuples)
        : file_(std::move(file)), data_(data), tuples_(tuples) {}

    bool found(const std::string& name) const { return data_->GetAbstractArray(name.c_str()) != nullptr; }
    vtkDoubleArray* doubles(const std::string& name, int components) const;
    std::vector<Id> integers(const std::string& name, int components = 1) const;  // of all tuples in their order
    std::vector<std::string> words(const std::string& name) const;                // of any length

    [[noreturn]] void fail(const std::string& reason) const;

private:
    vtkAbstractArray* get(const std::string& name, int components) const;

    std::filesystem::path file_;
    vtkFieldData* data_;
    vtkIdType tuples_;
};

}  // namespace pfem
