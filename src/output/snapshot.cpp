#include "mote/output/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "mote/output/files.hpp"
#include "mote/output/hdf5.hpp"
#include "mote/output/particle_ids.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// VTK wants three components for every position and vector.
std::vector<double> in_three_components(const Field& field, Index count) {
  std::vector<double> padded(3 * static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    std::copy_n(field.values.begin() + static_cast<std::ptrdiff_t>(i) * field.components,
                field.components, padded.begin() + static_cast<std::ptrdiff_t>(3 * i));
  return padded;
}

void write_point_data(hid_t vtk, const Cloud& cloud) {
  const auto points = static_cast<hsize_t>(cloud.count());
  const hdf5::Handle data = hdf5::create_group(vtk, "PointData");
  hdf5::write(data, std::string(id_field), H5T_NATIVE_INT64, ids(cloud).data(), points);
  for (const Field& field : cloud.fields()) {
    if (field.name == "position" || field.name == id_field) continue;
    if (field.kind == FieldKind::scalar)
      hdf5::write(data, field.name, H5T_NATIVE_DOUBLE, field.values.data(), points);
    else
      hdf5::write(data, field.name, H5T_NATIVE_DOUBLE,
                  in_three_components(field, cloud.count()).data(), points, 3);
  }
}

void write_vtk(hid_t file, const Cloud& cloud) {
  const std::int64_t points = cloud.count();
  const hdf5::Handle vtk = hdf5::create_group(file, "VTKHDF");
  hdf5::write_attribute(vtk, "Version", std::array<std::int64_t, 2>{1, 0});
  hdf5::write_attribute(vtk, "Type", std::string("UnstructuredGrid"));
  const std::int64_t cells = 1;
  hdf5::write(vtk, "NumberOfPoints", H5T_NATIVE_INT64, &points, 1);
  hdf5::write(vtk, "NumberOfCells", H5T_NATIVE_INT64, &cells, 1);
  hdf5::write(vtk, "NumberOfConnectivityIds", H5T_NATIVE_INT64, &points, 1);
  hdf5::write(vtk, "Points", H5T_NATIVE_DOUBLE,
              in_three_components(cloud.fields().front(), cloud.count()).data(),
              static_cast<hsize_t>(points), 3);
  std::vector<std::int64_t> connectivity(static_cast<std::size_t>(points));
  std::iota(connectivity.begin(), connectivity.end(), 0);
  hdf5::write(vtk, "Connectivity", H5T_NATIVE_INT64, connectivity.data(),
              static_cast<hsize_t>(points));
  const std::array<std::int64_t, 2> offsets{0, points};
  hdf5::write(vtk, "Offsets", H5T_NATIVE_INT64, offsets.data(), 2);
  constexpr unsigned char poly_vertex = 2;
  hdf5::write(vtk, "Types", H5T_NATIVE_UCHAR, &poly_vertex, 1);
  write_point_data(vtk, cloud);
}

/// The lists of a restart with the names of their data sets.
template <class Lists>
auto named_lists(Lists& restart) {
  using List = std::remove_reference_t<decltype((restart.values))>;
  return std::array<std::pair<std::string, List*>, 4>{{{"values", &restart.values},
                                                       {"rounding", &restart.rounding},
                                                       {"integrator", &restart.integrator},
                                                       {"path", &restart.path}}};
}

/// Tells whether the numbers of a state are those that were written: FNV-1a, a number at a time.
std::string checksum(const Cloud& cloud, const Restart& restart) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](const std::vector<double>& values) {
    for (const double value : values)
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
  };
  for (const Field& field : cloud.fields()) add(field.values);
  for (const auto& [name, list] : named_lists(restart)) add(*list);
  return fmt::format("{:016x}", hash);
}

void write_start_of_step(hid_t group, const Restart& restart) {
  if (restart.empty()) return;
  const hdf5::Handle start = hdf5::create_group(group, "start_of_step");
  hdf5::write_attribute(start, "step", std::span(&restart.step, 1));
  hdf5::write_attribute(start, "time", restart.time);
  for (const auto& [name, list] : named_lists(restart))
    if (!list->empty())
      hdf5::write(start, name, H5T_NATIVE_DOUBLE, list->data(), static_cast<hsize_t>(list->size()));
}

Restart read_start_of_step(hid_t group) {
  Restart restart;
  if (!hdf5::has(group, "start_of_step")) return restart;
  const hdf5::Handle start = hdf5::open_group(group, "start_of_step");
  restart.step = hdf5::read_integer(start, "step");
  restart.time = hdf5::read_double(start, "time");
  for (const auto& [name, list] : named_lists(restart))
    if (hdf5::has(start, name)) *list = hdf5::read_doubles(start, name);
  return restart;
}

/// The corners of bodies that have no particles, by the number of the body.
void write_outlines(hid_t group, const Scene& scene) {
  const auto has_outline = [](const Body& body) { return !body.outline.empty(); };
  if (std::ranges::none_of(scene.bodies, has_outline)) return;
  const hdf5::Handle outlines = hdf5::create_group(group, "outlines");
  for (std::size_t number = 0; number < scene.bodies.size(); ++number) {
    std::vector<double> corners;
    for (const Triple& corner : scene.bodies[number].outline)
      corners.insert(corners.end(), {corner[0], corner[1]});
    if (!corners.empty())
      hdf5::write(outlines, std::to_string(number), H5T_NATIVE_DOUBLE, corners.data(),
                  corners.size() / 2, 2);
  }
}

/// Names and kinds of bodies are one string each, a line a body.
void write_scene(hid_t group, const Scene& scene) {
  std::string names, kinds;
  for (const Body& body : scene.bodies) {
    names += body.name + '\n';
    kinds += body.kind == BodyKind::fluid ? "fluid\n" : "wall\n";
  }
  hdf5::write_attribute(group, "spacing", scene.spacing);
  hdf5::write_attribute(group, "body_names", names);
  hdf5::write_attribute(group, "body_kinds", kinds);
  write_outlines(group, scene);
}

/// The restart group: attributes, and each field with its components; scalars are hard links to
/// the arrays that VTK reads.
void write_restart(hid_t file, const Moment& moment, const std::string& fingerprint,
                   const Cloud& cloud, const Scene& scene, const Restart& restart) {
  const hdf5::Handle group = hdf5::create_group(file, "mote");
  hdf5::write_attribute(group, "frame", std::span(&moment.frame, 1));
  hdf5::write_attribute(group, "step", std::span(&moment.step, 1));
  hdf5::write_attribute(group, "time", moment.time);
  hdf5::write_attribute(group, "scenario", fingerprint);
  hdf5::write_attribute(group, "checksum", checksum(cloud, restart));
  const std::int64_t dimension = cloud.dimension(), count = cloud.count();
  hdf5::write_attribute(group, "dimension", std::span(&dimension, 1));
  hdf5::write_attribute(group, "particles", std::span(&count, 1));
  if (!scene.bodies.empty()) write_scene(group, scene);
  write_start_of_step(group, restart);
  const hdf5::Handle state = hdf5::create_group(group, "state");
  for (const Field& field : cloud.fields()) {
    if (field.kind == FieldKind::vector) {
      hdf5::write(state, field.name, H5T_NATIVE_DOUBLE, field.values.data(),
                  static_cast<hsize_t>(count), static_cast<hsize_t>(field.components));
    } else {
      const std::string source = "/VTKHDF/PointData/" + field.name;
      hdf5::require(
          H5Lcreate_hard(file, source.c_str(), state, field.name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
          field.name);
    }
    const hdf5::Handle set(H5Dopen2(state, field.name.c_str(), H5P_DEFAULT), H5Dclose, field.name);
    hdf5::write_attribute(set, "kind",
                          std::string(field.kind == FieldKind::vector ? "vector" : "scalar"));
    hdf5::write_attribute(set, "unit", field.si_unit);
  }
}

Cloud read_cloud(hid_t group) {
  const std::int64_t count = hdf5::read_integer(group, "particles");
  Cloud cloud(static_cast<int>(hdf5::read_integer(group, "dimension")), static_cast<Index>(count));
  const hdf5::Handle state = hdf5::open_group(group, "state");
  for (const std::string& name : hdf5::members(state)) {
    const std::vector<double> values = hdf5::read_doubles(state, name);
    const hdf5::Handle set(H5Dopen2(state, name.c_str(), H5P_DEFAULT), H5Dclose, name);
    if (!cloud.has(name))
      cloud.add(name,
                hdf5::read_string(set, "kind") == "vector" ? FieldKind::vector : FieldKind::scalar,
                hdf5::read_string(set, "unit"));
    const std::span<double> target = cloud.values(name);
    if (values.size() != target.size())
      throw std::runtime_error("the field " + name + " has the wrong size");
    std::ranges::copy(values, target.begin());
  }
  return cloud;
}

Moment moment_in(hid_t group) {
  return {hdf5::read_integer(group, "frame"), hdf5::read_integer(group, "step"),
          hdf5::read_double(group, "time")};
}

Snapshot read_whole(hid_t group) {
  Snapshot snapshot{moment_in(group), hdf5::read_string(group, "scenario"), read_cloud(group),
                    read_start_of_step(group)};
  if (checksum(snapshot.cloud, snapshot.restart) != hdf5::read_string(group, "checksum"))
    throw std::runtime_error("its numbers are not those that were written");
  return snapshot;
}

/// What `read` makes of the restart group of a file, or an InputError that names the file.
template <class Read>
auto read_restart(const std::filesystem::path& path, Read read) {
  hdf5::be_quiet();
  try {
    const hdf5::Handle file = hdf5::open_file(path.string());
    return read(hdf5::open_group(file, "mote"));
  } catch (const std::runtime_error& error) {
    throw InputError(fmt::format("{}: this snapshot is damaged or not one of mote: {}",
                                 path.string(), error.what()));
  }
}

}  // namespace

Scene scene_of(const Model& model) { return {model.spacing(), model.bodies()}; }

void write_snapshot(const std::filesystem::path& path, const Moment& moment,
                    const std::string& fingerprint, const Cloud& cloud, const Scene& scene,
                    const Restart& restart) {
  hdf5::be_quiet();
  try {
    const hdf5::Handle file = hdf5::create_file(unfinished(path).string());
    write_vtk(file, cloud);
    write_restart(file, moment, fingerprint, cloud, scene, restart);
    hdf5::require(H5Fflush(file, H5F_SCOPE_LOCAL), "the disk may be full");
  } catch (const std::runtime_error& error) {
    throw InputError(
        fmt::format("{}: cannot write this snapshot: {}", path.string(), error.what()));
  }
  finish(path);
}

Moment read_moment(const std::filesystem::path& path) {
  return read_restart(path, [](hid_t group) { return moment_in(group); });
}

Snapshot read_snapshot(const std::filesystem::path& path) { return read_restart(path, read_whole); }

}  // namespace mote
