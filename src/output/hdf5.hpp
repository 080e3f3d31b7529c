#pragma once

#include <hdf5.h>

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mote::hdf5 {

/// An open HDF5 object, closed at the end of its scope. A negative identifier, HDF5's sign of an
/// error, throws std::runtime_error with `what`.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close close, const std::string& what);
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Throws std::runtime_error with `what` if `status` is HDF5's sign of an error.
void require(herr_t status, const std::string& what);

/// Stops HDF5 from printing its error stack: errors are reported by exceptions.
void be_quiet();

Handle create_file(const std::string& path);
Handle open_file(const std::string& path);
Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

/// Writes a data set of rows x columns numbers; columns = 0 makes it one-dimensional. No times are
/// stored, so equal contents give equal bytes.
void write(hid_t group, const std::string& name, hid_t type, const void* values, hsize_t rows,
           hsize_t columns = 0);

/// Reads a data set of doubles whatever its shape.
std::vector<double> read_doubles(hid_t group, const std::string& name);

void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, const std::string& value);
std::int64_t read_integer(hid_t object, const std::string& name);
double read_double(hid_t object, const std::string& name);
std::string read_string(hid_t object, const std::string& name);

/// Whether a group has a member of this name.
bool has(hid_t group, const std::string& name);

/// The lengths of a data set of numbers, {1} for a single number; nothing for any other member.
std::optional<std::vector<hsize_t>> shape_of_numbers(hid_t group, const std::string& name);

/// The names of a group's members in the order in which they were made, as far as the group keeps
/// it, else in alphabetical order.
std::vector<std::string> members(hid_t group);

}  // namespace mote::hdf5
