#include "io/gridArrays.hpp"

#include <cmath>

#include "base/error.hpp"

namespace pfem {

vtkSmartPointer<vtkStringArray> makeWords(const std::string& name, const std::vector<std::string>& words) {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetName(name.c_str());
    for (const auto& word : words) array->InsertNextValue(word);
    return array;
}

void CheckedArrays::fail(const std::string& reason) const {
    throw UserError("cannot read \"" + file_.string() + "\": " + reason, {file_.string(), 0});
}

vtkAbstractArray* CheckedArrays::get(const std::string& name, int components) const {
    vtkAbstractArray* array = data_->GetAbstractArray(name.c_str());
    if (array == nullptr) fail("array '" + name + "' is missing");
    if (array->GetNumberOfComponents() != components)
        fail("array '" + name + "' has " + std::to_string(array->GetNumberOfComponents()) + " components, not " +
             std::to_string(components));
    if (tuples_ >= 0 && array->GetNumberOfTuples() != tuples_)
        fail("array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) + " values, not " +
             std::to_string(tuples_));
    return array;
}

vtkDoubleArray* CheckedArrays::doubles(const std::string& name, int components) const {
    auto* array = vtkDoubleArray::SafeDownCast(get(name, components));
    if (array == nullptr) fail("array '" + name + "' is not of type Float64");
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
        if (!std::isfinite(array->GetValue(i))) fail("array '" + name + "' contains a value that is not finite");
    return array;
}

std::vector<Id> CheckedArrays::integers(const std::string& name, int components) const {
    auto* array = vtkDataArray::SafeDownCast(get(name, components));
    const int type = array == nullptr ? VTK_VOID : array->GetDataType();
    if (type != VTK_INT && type != VTK_LONG && type != VTK_LONG_LONG && type != VTK_ID_TYPE)
        fail("array '" + name + "' is not of type Int32 or Int64");
    std::vector<Id> values(static_cast<std::size_t>(array->GetNumberOfValues()));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = array->GetVariantValue(static_cast<vtkIdType>(i)).ToTypeInt64();
    return values;
}

std::vector<std::string> CheckedArrays::words(const std::string& name) const {
    vtkAbstractArray* array = data_->GetAbstractArray(name.c_str());
    if (array == nullptr) fail("array '" + name + "' is missing");
    auto* strings = vtkStringArray::SafeDownCast(array);
    if (strings == nullptr) fail("array '" + name + "' is not of type String");
    std::vector<std::string> words;
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i) words.push_back(strings->GetValue(i));
    return words;
}

}  // namespace pfem
