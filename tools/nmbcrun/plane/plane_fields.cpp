// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "generator/support/files.hpp"
#include "tools/nmbcrun/output/hdf5_file.hpp"

namespace nmbcrun {
namespace {

static_assert(std::endian::native == std::endian::little);

struct Quantity {
    std::string name;
    std::size_t components;
};

constexpr const char* displacement_label = "displacement";
constexpr const char* velocity_label = "velocity";
constexpr const char* energy_label = "energy";
constexpr const char* damage = "damage";

std::vector<Quantity> quantities_of(const PlaneScene& scene) {
    std::vector<Quantity> all{{displacement_label, 3}, {velocity_label, 3}, {energy_label, 1}};
    if (scene.fracture) {
        all.push_back({damage, 1});
    }
    return all;
}

/// Node by node, row by row.
std::vector<double> values_of(const PlaneSimulation& simulation, const Quantity& quantity) {
    if (quantity.name == energy_label) {
        return simulation.energy_density();
    }
    const auto [nx, ny] = simulation.body().nodes;
    std::vector<double> values;
    values.reserve(nx * ny * quantity.components);
    const nmbc::Plane& plane = simulation.plane();
    for (std::size_t y = 0; y < ny; ++y) {
        for (std::size_t x = 0; x < nx; ++x) {
            if (quantity.name == damage) {
                values.push_back(simulation.damage(x, y));
                continue;
            }
            const std::size_t entry = simulation.entry_of_body(x, y);
            for (const std::size_t a : {0U, 1U}) {
                values.push_back(quantity.name == displacement_label ? plane.displacement(a)[entry]
                                                                     : plane.velocity(a)[entry]);
            }
            values.push_back(0);
        }
    }
    return values;
}

/// Of the first node along an axis [length].
double origin_of(const PlaneSimulation& simulation, std::size_t axis) {
    return (1 - double(simulation.body().before[axis])) * simulation.scene().spacing;
}

std::string vti_text(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    std::string arrays;  // their descriptions
    std::string data;
    for (const Quantity& quantity : quantities_of(scene)) {
        arrays += fmt::format(
            "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" "
            "format=\"appended\" offset=\"{}\"/>\n",
            quantity.name, quantity.components, data.size());
        const std::vector<double> values = values_of(simulation, quantity);
        const std::uint64_t size = values.size() * sizeof(double);
        const std::size_t at = data.size();
        data.resize(at + sizeof(size) + size);
        std::memcpy(&data[at], &size, sizeof(size));
        std::memcpy(&data[at + sizeof(size)], values.data(), size);
    }
    return fmt::format(
               "<?xml version=\"1.0\"?>\n"
               "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
               "header_type=\"UInt64\">\n"
               "<ImageData WholeExtent=\"0 {0} 0 {1} 0 0\" Origin=\"{2} {3} 0\" "
               "Spacing=\"{4} {4} {4}\">\n"
               "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
               "format=\"ascii\">{5:.10g}</DataArray></FieldData>\n"
               "<Piece Extent=\"0 {0} 0 {1} 0 0\">\n<PointData Vectors=\"displacement\">\n{6}"
               "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_",
               simulation.body().nodes[0] - 1, simulation.body().nodes[1] - 1,
               origin_of(simulation, 0), origin_of(simulation, 1), scene.spacing,
               simulation.plane().time(), arrays) +
           data + "\n</AppendedData>\n</VTKFile>\n";
}

Hdf5File::Attributes described_as(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    const auto place = [&](char index, std::size_t axis) {
        const auto shift = 1 - std::ptrdiff_t(simulation.body().before[axis]);
        return fmt::format("({} {} {}) dX", index, shift < 0 ? '-' : '+', std::abs(shift));
    };
    return {
        {"title", scene.title},
        {"nodes", fmt::format("dataset[j, i] is of X = {}, Y = {}", place('i', 0), place('j', 1))},
        {"dX", fmt::format("{}", scene.spacing)}};
}

nmbcgen::NewFile new_hdf5(const PlaneSimulation& simulation, const std::filesystem::path& path) {
    const PlaneScene& scene = simulation.scene();
    Hdf5File file(path);
    file.describe(described_as(simulation));
    for (const Quantity& quantity : quantities_of(scene)) {
        std::vector<std::size_t> extents{simulation.body().nodes[1], simulation.body().nodes[0]};
        if (quantity.components > 1) {
            extents.push_back(quantity.components);
        }
        const bool is_half_step_before =
            quantity.name == velocity_label || quantity.name == energy_label;
        const double half_step = is_half_step_before ? simulation.plan().time_step / 2 : 0;
        file.add(quantity.name, extents,
                 {{"time", fmt::format("{:.10g}", simulation.plane().time() - half_step)}});
        file.write(quantity.name, values_of(simulation, quantity));
    }
    return file.whole();
}

nmbcgen::NewFile new_vti(const PlaneSimulation& simulation, const std::filesystem::path& path) {
    nmbcgen::require_replaceable(path);
    nmbcgen::PosixFile file = nmbcgen::PosixFile::create_beside(path);
    nmbcgen::NewFile made(file.path(), path);
    file.write(vti_text(simulation));
    file.sync();
    return made;
}

std::string pvd_text(const std::vector<Snapshot>& snapshots) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const auto& [time, file] : snapshots) {
        text += fmt::format("<DataSet timestep=\"{:.10g}\" file=\"{}\"/>\n", time,
                            file.generic_string());
    }
    return text + "</Collection>\n</VTKFile>\n";
}

/// The extents of each dataset are the file's own, which ParaView's Xdmf3 readers require.
std::string xdmf_text(const PlaneSimulation& simulation, const std::vector<Snapshot>& snapshots) {
    const PlaneScene& scene = simulation.scene();
    const auto [nx, ny] = simulation.body().nodes;
    std::string text =
        "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
        "<Grid Name=\"plane\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (const auto& [time, file] : snapshots) {
        text += fmt::format(
            "<Grid Name=\"nodes\">\n<Time Value=\"{0:.10g}\"/>\n"
            "<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"1 {2} {1}\"/>\n"
            "<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
            "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">"
            "0 {4} {3}</DataItem>\n"
            "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">"
            "{5} {5} {5}</DataItem>\n</Geometry>\n",
            time, nx, ny, origin_of(simulation, 0), origin_of(simulation, 1), scene.spacing);
        for (const auto& [name, components] : quantities_of(scene)) {
            text += fmt::format(
                "<Attribute Name=\"{0}\" AttributeType=\"{1}\" Center=\"Node\">\n"
                "<DataItem Dimensions=\"{3} {2}{4}\" NumberType=\"Float\" Precision=\"8\" "
                "Format=\"HDF\">{5}:/{0}</DataItem>\n</Attribute>\n",
                name, components > 1 ? "Vector" : "Scalar", nx, ny, components > 1 ? " 3" : "",
                file.generic_string());
        }
        text += "</Grid>\n";
    }
    return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

void write_links(const PlaneSimulation& simulation, const std::filesystem::path& path,
                 const std::vector<Snapshot>& snapshots) {
    Hdf5File file(path);
    file.describe(described_as(simulation));
    file.add("time", {snapshots.size()}, {{"of", "displacement"}});
    std::vector<double> times;
    for (const Snapshot& snapshot : snapshots) {
        times.push_back(snapshot.time);
        for (const Quantity& quantity : quantities_of(simulation.scene())) {
            file.link(quantity.name + "/" + snapshot.file.stem().string(),
                      snapshot.file.generic_string(), "/" + quantity.name);
        }
    }
    file.write("time", times);
    std::vector<nmbcgen::NewFile> files;
    files.push_back(file.whole());
    nmbcgen::publish(files);
}

}  // namespace

std::string_view extension_of(FieldFormat format) {
    return format == FieldFormat::vtk ? ".vti" : ".h5";
}

double bytes_of_fields(const PlaneSimulation& simulation) {
    const auto [nx, ny] = simulation.body().nodes;
    double bytes = 0;
    for (const Quantity& quantity : quantities_of(simulation.scene())) {
        bytes += double(nx) * double(ny) * double(quantity.components * sizeof(double));
    }
    return bytes;
}

nmbcgen::NewFile new_fields(const PlaneSimulation& simulation, const std::filesystem::path& path) {
    std::error_code error;  // what cannot be made cannot be written to
    std::filesystem::create_directories(path.parent_path(), error);
    return simulation.scene().field_format == FieldFormat::vtk ? new_vti(simulation, path)
                                                               : new_hdf5(simulation, path);
}

void write_fields(const PlaneSimulation& simulation, const std::filesystem::path& path) {
    std::vector<nmbcgen::NewFile> files;
    files.push_back(new_fields(simulation, path));
    nmbcgen::publish(files);
}

void write_series(const PlaneSimulation& simulation, const std::filesystem::path& folder,
                  const std::vector<Snapshot>& snapshots) {
    const PlaneScene& scene = simulation.scene();
    if (scene.field_format == FieldFormat::vtk) {
        nmbcgen::write_files({{folder / series_name(scene), pvd_text(snapshots)}});
        return;
    }
    write_links(simulation, folder / (scene.name + ".h5"), snapshots);
    nmbcgen::write_files({{folder / series_name(scene), xdmf_text(simulation, snapshots)}});
}

std::string series_name(const PlaneScene& scene) {
    return scene.name + (scene.field_format == FieldFormat::vtk ? ".pvd" : ".xdmf");
}

}  // namespace nmbcrun
