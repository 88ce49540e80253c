#pragma once
// Types that say where the numbers of an array live. With nodal integration the stress points are the nodes, with
// elemental the cells: the arrays then have the same length, so that only their type can tell them apart.

#include <utility>
#include <vector>

namespace pfem {

/// An array with one value for each of Where. Nothing else converts to it or from it unless that is asked for.
template <class Where, class Value>
class FieldOn : private std::vector<Value> {
    using Array = std::vector<Value>;

public:
    using Array::Array;
    FieldOn() = default;
    explicit FieldOn(Array values) : Array(std::move(values)) {}

    using typename Array::value_type;
    using Array::operator[];
    using Array::assign;
    using Array::begin;
    using Array::data;
    using Array::empty;
    using Array::end;
    using Array::resize;
    using Array::size;

    /// The array alone.
    const Array& values() const& { return *this; }
    Array values() && { return std::move(*this); }
};

/// One value for each cell.
template <class Value>
using PerCell = FieldOn<struct OnCells, Value>;

/// One value for each stress point (stressPoints.hpp).
template <class Value>
using PerPoint = FieldOn<struct OnStressPoints, Value>;

/// One value for each node: arrays as those of Nodes.
template <class Value>
using PerNode = std::vector<Value>;

}  // namespace pfem
