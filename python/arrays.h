#pragma once

// NumPy arrays as those of raycheck/batch.h.

#include <pybind11/numpy.h>
#include <raycheck/batch.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

namespace raycheck::python {

namespace py = pybind11;

/// The index of an option's value among its names.
template <std::size_t N>
int32_t index_of(const char* option, const std::string& given,
                 const std::array<const char*, N>& names) {
  std::string all;
  for (std::size_t k = 0; k < N; ++k) {
    if (given == names[k]) return static_cast<int32_t>(k);
    all += std::string(k == 0 ? "" : k + 1 == N ? " or " : ", ") + names[k];
  }
  throw py::value_error(std::string(option) + " = " + given + ": must be " + all);
}

using Shape = std::vector<py::ssize_t>;

/// Between this many answers Python's signals are looked at.
constexpr py::ssize_t kBlock = py::ssize_t{1} << 20;

/// Numbers, or points of three numbers, as the caller's array has them: strides are in bytes.
struct Operand {
  py::array array;
  Shape shape, strides;        ///< Of the points; without the axis of coordinates.
  py::ssize_t coordinate = 0;  ///< Bytes from x to y; 0 for numbers.
  int32_t type = RAYCHECK_FLOAT64;

  const char* data() const { return static_cast<const char*>(array.data()); }
  py::ssize_t item() const { return type == RAYCHECK_FLOAT32 ? sizeof(float) : sizeof(double); }
  /// Bytes from one element to the next along an axis of the result.
  py::ssize_t stride(std::size_t axis, std::size_t axes) const {
    if (axis + shape.size() < axes) return 0;
    const std::size_t own = axis + shape.size() - axes;
    return shape[own] == 1 ? 0 : strides[own];
  }
};

/// Of this type, in the machine's order of bytes.
template <class Number>
bool is_of(const py::array& array) {
  return py::detail::npy_format_descriptor<Number>::value == array.dtype().num() &&
         array.dtype().byteorder() == '=';
}

/// Doubles and floats are used as they are; other numbers are converted to doubles.
inline Operand operand(const char* name, const py::handle& from, bool is_point) {
  py::array array = py::array::ensure(from);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": must be an array of numbers");
  }
  Operand found;
  if (is_of<float>(array)) {
    found.type = RAYCHECK_FLOAT32;
  } else if (!is_of<double>(array)) {
    if (std::strchr("biuf", array.dtype().kind()) == nullptr) {
      throw py::type_error(std::string(name) + ": must be an array of numbers, not of " +
                           py::str(array.dtype()).cast<std::string>());
    }
    array = py::array_t<double, py::array::forcecast>::ensure(array);
  }
  if ((array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) == 0) {
    array = array.attr("copy")();
  }
  auto axes = static_cast<std::size_t>(array.ndim());
  if (is_point) {
    if (axes == 0 || array.shape(array.ndim() - 1) != 3) {
      throw py::value_error(std::string(name) + ": must have the shape (..., 3), not " +
                            py::str(array.attr("shape")).cast<std::string>());
    }
    found.coordinate = array.strides(array.ndim() - 1);
    --axes;
  }
  found.shape.assign(array.shape(), array.shape() + axes);
  found.strides.assign(array.strides(), array.strides() + axes);
  found.array = std::move(array);
  return found;
}

inline std::string text(const Shape& shape) {
  std::string all;
  for (const py::ssize_t size : shape) all += (all.empty() ? "" : ", ") + std::to_string(size);
  return "(" + all + (shape.size() == 1 ? ",)" : ")");
}

/// The shape of the answers, as NumPy broadcasts, and the runs of answers that one call gives.
class Layout {
 public:
  explicit Layout(std::initializer_list<const Operand*> operands) : operands_(operands) {
    for (const Operand* one : operands_) {
      shape.resize(std::max(shape.size(), one->shape.size()), 1);
    }
    for (const Operand* one : operands_) {
      const std::size_t shift = shape.size() - one->shape.size();
      for (std::size_t k = 0; k < one->shape.size(); ++k) {
        py::ssize_t& size = shape[k + shift];
        if (size == 1) size = one->shape[k];
        if (one->shape[k] != size && one->shape[k] != 1) refuse();
      }
    }
    for (const py::ssize_t size : shape) count *= size;
    outer = shape.size();
    const bool varies = std::any_of(operands_.begin(), operands_.end(), [&](const Operand* one) {
      return !shape.empty() && one->stride(shape.size() - 1, shape.size()) != 0;
    });
    while (varies && outer > 0 && joins(outer - 1)) run *= shape[--outer];
  }

  /// Where an operand's elements of the run at a flat index begin, and their stride.
  std::size_t offset(const Operand& of, py::ssize_t flat) const {
    py::ssize_t bytes = flat % run * stride(of);
    flat /= run;
    for (std::size_t axis = outer; axis-- > 0; flat /= shape[axis]) {
      bytes += flat % shape[axis] * of.stride(axis, shape.size());
    }
    return static_cast<std::size_t>(bytes);
  }
  py::ssize_t stride(const Operand& of) const {
    return outer == shape.size() ? 0 : of.stride(shape.size() - 1, shape.size());
  }

  /// "[2, 5]", the place in an operand of the element that answers of this flat index use.
  std::string place(const Operand& of, py::ssize_t flat) const {
    std::string all;
    for (std::size_t axis = shape.size(); axis-- > 0; flat /= shape[axis]) {
      if (axis + of.shape.size() < shape.size()) break;
      const bool is_one = of.shape[axis + of.shape.size() - shape.size()] == 1;
      all = std::to_string(is_one ? 0 : flat % shape[axis]) + (all.empty() ? "" : ", ") + all;
    }
    return all.empty() ? "" : "[" + all + "]";
  }

  Shape shape;
  py::ssize_t count = 1;  ///< Of the answers.
  py::ssize_t run = 1;    ///< Answers that a single call gives: the last axes, from `outer` on.
  std::size_t outer = 0;

 private:
  /// Whether an axis continues the runs of the axes after it.
  bool joins(std::size_t axis) const {
    if (axis + 1 == shape.size()) return true;
    return std::all_of(operands_.begin(), operands_.end(), [&](const Operand* one) {
      return one->stride(axis, shape.size()) == one->stride(shape.size() - 1, shape.size()) * run;
    });
  }
  [[noreturn]] void refuse() const {
    std::string all;
    for (const Operand* one : operands_) all += (all.empty() ? "" : ", ") + text(one->shape);
    throw py::value_error("the shapes " + all + " cannot be broadcast together");
  }

  std::vector<const Operand*> operands_;
};

/// An array that is made for answers: one number, or three, for each.
struct Made {
  py::array array;
  char* data = nullptr;
  py::ssize_t item = 0;
  int32_t type = RAYCHECK_FLOAT64;

  Made() = default;
  Made(const Shape& answers, int32_t as, bool is_point = false) : type(as) {
    static const std::array<py::dtype, 4> kTypes = {py::dtype("f8"), py::dtype("f4"),
                                                    py::dtype("u1"), py::dtype("i4")};
    Shape all = answers;
    if (is_point) all.push_back(3);
    array = py::array(kTypes.at(static_cast<std::size_t>(as)), all);
    data = static_cast<char*>(array.mutable_data());
    item = array.itemsize();
  }
  raycheck_output part(py::ssize_t first, py::ssize_t count) const {
    return {data == nullptr ? nullptr : data + first * item, static_cast<std::size_t>(count), 0,
            type};
  }
  raycheck_output3 part3(py::ssize_t first, py::ssize_t count) const {
    if (data == nullptr) return {nullptr, nullptr, nullptr, 0, 0, type};
    char* const x = data + 3 * first * item;
    return {x, x + item, x + 2 * item, static_cast<std::size_t>(count), 3 * item, type};
  }
};

inline raycheck_array part(const Operand& of, const Layout& in, py::ssize_t first,
                           py::ssize_t count) {
  const py::ssize_t stride = in.stride(of);
  if (count == 0) return {of.data(), 0, stride, of.type};  // NumPy's strides are then 0
  return {of.data() + in.offset(of, first), stride == 0 ? 1 : static_cast<std::size_t>(count),
          stride, of.type};
}
inline raycheck_array3 part3(const Operand& of, const Layout& in, py::ssize_t first,
                             py::ssize_t count) {
  const raycheck_array x = part(of, in, first, count);
  const char* const at = static_cast<const char*>(x.data);
  return {at, at + of.coordinate, at + 2 * of.coordinate, x.count, x.stride, of.type};
}

}  // namespace raycheck::python
