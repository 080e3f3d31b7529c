#include "mote/output/hdf5.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace mote::hdf5 {
namespace {

/// Creation properties of files, data sets or groups without times, members in order of creation.
Handle untimed(hid_t type) {
  Handle properties(H5Pcreate(type), H5Pclose, "creation properties");
  require(H5Pset_obj_track_times(properties, false), "creation properties");
  if (type == H5P_GROUP_CREATE)
    require(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
            "creation order");
  return properties;
}

Handle open_attribute(hid_t object, const std::string& name) {
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "no attribute " + name};
}

void write_attribute(hid_t object, const std::string& name, hid_t type, hid_t space,
                     const void* values) {
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "attribute " + name);
  require(H5Awrite(attribute, type, values), "attribute " + name);
}

/// The type of a string of this many characters.
Handle string_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
  require(H5Tset_size(type, size), "string type");
  require(H5Tset_strpad(type, H5T_STR_NULLPAD), "string type");
  return type;
}

template <class T>
T read_attribute(hid_t object, const std::string& name, hid_t type) {
  T value{};
  require(H5Aread(open_attribute(object, name), type, &value), "attribute " + name);
  return value;
}

bool is_of_numbers(hid_t data_set, const std::string& name) {
  const Handle type(H5Dget_type(data_set), H5Tclose, "data set " + name);
  const H5T_class_t kind = H5Tget_class(type);
  return kind == H5T_INTEGER || kind == H5T_FLOAT;
}

bool keeps_order(hid_t group) {
  const Handle properties(H5Gget_create_plist(group), H5Pclose, "members of a group");
  unsigned order = 0;
  require(H5Pget_link_creation_order(properties, &order), "members of a group");
  return (order & H5P_CRT_ORDER_INDEXED) != 0;
}

}  // namespace

Handle::Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw std::runtime_error(what);
}

void require(herr_t status, const std::string& what) {
  if (status < 0) throw std::runtime_error(what);
}

void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Handle create_file(const std::string& path) {
  // The format of HDF5 1.8 has checksums over everything but the data.
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file access");
  require(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "file format");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, untimed(H5P_FILE_CREATE), access), H5Fclose,
          "cannot write this file"};
}

Handle open_file(const std::string& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
          "this is not a whole HDF5 file"};
}

Handle create_group(hid_t parent, const std::string& name) {
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, untimed(H5P_GROUP_CREATE), H5P_DEFAULT),
          H5Gclose, "group " + name};
}

Handle open_group(hid_t parent, const std::string& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "there is no group " + name};
}

void write(hid_t group, const std::string& name, hid_t type, const void* values, hsize_t rows,
           hsize_t columns) {
  const std::array<hsize_t, 2> shape{rows, columns};
  const Handle space(H5Screate_simple(columns > 0 ? 2 : 1, shape.data(), nullptr), H5Sclose, name);
  const Handle set(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT,
                              untimed(H5P_DATASET_CREATE), H5P_DEFAULT),
                   H5Dclose, name);
  require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
}

std::vector<double> read_doubles(hid_t group, const std::string& name) {
  const Handle set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "no data set " + name);
  const Handle space(H5Dget_space(set), H5Sclose, "data set " + name);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  require(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "data set " + name);
  return values;
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t size = values.size();
  const Handle space(size == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr),
                     H5Sclose, name);
  write_attribute(object, name, H5T_NATIVE_INT64, space, values.data());
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  write_attribute(object, name, H5T_NATIVE_DOUBLE, space, &value);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  write_attribute(object, name, string_type(std::max<std::size_t>(1, value.size())), space,
                  value.c_str());
}

std::int64_t read_integer(hid_t object, const std::string& name) {
  return read_attribute<std::int64_t>(object, name, H5T_NATIVE_INT64);
}

double read_double(hid_t object, const std::string& name) {
  return read_attribute<double>(object, name, H5T_NATIVE_DOUBLE);
}

std::string read_string(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, "attribute " + name);
  std::string value(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, value.data()), "attribute " + name);
  value.resize(std::min(value.size(), value.find('\0')));  // padding
  return value;
}

bool has(hid_t group, const std::string& name) {
  return H5Lexists(group, name.c_str(), H5P_DEFAULT) > 0;
}

std::optional<std::vector<hsize_t>> shape_of_numbers(hid_t group, const std::string& name) {
  const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "there is no " + name);
  if (H5Iget_type(object) != H5I_DATASET || !is_of_numbers(object, name)) return std::nullopt;
  const Handle space(H5Dget_space(object), H5Sclose, "data set " + name);
  const int dimensions = H5Sget_simple_extent_ndims(space);
  require(dimensions, "data set " + name);
  if (dimensions == 0) return std::vector<hsize_t>{1};
  std::vector<hsize_t> shape(static_cast<std::size_t>(dimensions));
  require(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "data set " + name);
  return shape;
}

std::vector<std::string> members(hid_t group) {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* result) -> herr_t {
    static_cast<std::vector<std::string>*>(result)->emplace_back(name);
    return 0;
  };
  const H5_index_t order = keeps_order(group) ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  require(H5Literate(group, order, H5_ITER_INC, nullptr, collect, &names), "members of a group");
  return names;
}

}  // namespace mote::hdf5
