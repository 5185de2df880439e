// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nmbc/plane_convex_kernel.hpp>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/names/projected_family.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/plane/read_plane_sides.hpp"
#include "tools/nmbcrun/plane/read_plane_sources.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {
namespace {

/// An exact number, which may be below 0.
std::optional<nmbcgen::Rational> read_signed(SceneReader& reader, const std::string& key) {
    const auto given = reader.number_or_text(key);
    if (!given) {
        return std::nullopt;
    }
    try {
        return nmbcgen::parse_signed_rational(*given);
    } catch (const std::invalid_argument&) {
        reader.fail(
            key, fmt::format(R"(must be an exact number, such as 0.25 or "-1/4", not {})", *given));
    }
}

/// The bonds' weights or, of radius N, the factors alpha of the micromodulus 48/(5 pi N^3).
void read_bonds(SceneReader& reader, PlaneScene& scene) {
    for (const char* const key :
         {"model.nu", "model.state", "model.G", "model.damping", "model.influence"}) {
        if (reader.has(key)) {
            reader.fail(key, "does not count for \"bond2d\": bonds have nu = 1/4 in plane strain");
        }
    }
    scene.weights = reader.numbers("model.weights", any_number);
    std::vector<double> alpha = reader.numbers("model.alpha", any_number);
    if (!scene.weights.empty() && !alpha.empty()) {
        reader.fail("model.alpha", "and model.weights say the same: give one");
    }
    if (scene.weights.empty() && alpha.empty()) {
        reader.fail("model",
                    "of \"bond2d\" needs one of alpha and weights, a number for each class "
                    "of bonds (nmbcgen bonds --dimension 2 makes them)");
    }
    const std::vector<double>& given = alpha.empty() ? scene.weights : alpha;
    const auto classes = nmbc::plane_bond_classes(scene.radius_squared);
    const auto zero = std::ranges::find(given, 0.0);
    if (given.size() != classes.size() || zero != given.end()) {
        const std::string wrong = given.size() != classes.size()
                                      ? fmt::format("has length {}", given.size())
                                      : fmt::format("has 0 as number {}", zero - given.begin() + 1);
        reader.fail(alpha.empty() ? "model.weights" : "model.alpha",
                    fmt::format("{}; {} is needed, a number other than 0 for each of the bonds {}",
                                wrong, classes.size(), nmbc::detail::list_of_bonds(classes)));
    }
    try {
        if (!alpha.empty()) {
            scene.weights = nmbc::bond_weights(scene.radius_squared, alpha);
        }
        if (bonds_of(scene).speed_S() == 0) {
            throw std::invalid_argument("bonds of radius 1 do not resist shear");
        }
    } catch (const std::invalid_argument& error) {
        reader.fail("model", "is no lattice: " + std::string(error.what()));
    }
}

/// A name, or a number for each length of bonds; none: constant.
std::vector<double> read_plane_influence(SceneReader& reader, unsigned radius_squared) {
    constexpr const char* key = "model.influence";
    if (!reader.is_text(key)) {
        std::vector<double> numbers = reader.numbers(key, positive);
        const auto lengths = nmbc::squared_lengths(radius_squared);
        if (reader.has(key) && numbers.size() != lengths.size()) {
            reader.fail(key,
                        fmt::format("has length {}; {} is needed, a number for each squared length "
                                    "of bonds, {}",
                                    numbers.size(), lengths.size(), fmt::join(lengths, ", ")));
        }
        constexpr double widest = 1e300;  // over their mean, no number is 0
        if (!numbers.empty() && std::ranges::max(numbers) / widest > std::ranges::min(numbers)) {
            reader.fail(key, fmt::format("has numbers that are more than {} times others", widest));
        }
        return numbers;
    }
    const bool is_spline =
        read_choice<bool>(reader, key, {{"constant", false}, {"spline", true}}) == true;
    try {
        return is_spline ? nmbc::spline_influence(radius_squared) : std::vector<double>{};
    } catch (const std::invalid_argument& error) {
        reader.fail(key, std::string("does not fit model.radius2: ") + error.what());
    }
}

/// It has no default, as that of a chain.
double read_plane_G(SceneReader& reader, const PlaneScene& scene) {
    if (const auto G = reader.is_text("model.G") ? read_signed(reader, "model.G") : std::nullopt) {
        return nmbcgen::nearest_double(*G);
    }
    const auto G = reader.number("model.G", not_negative);
    if (!G) {
        PlaneScene undamped = scene;
        undamped.tau = 0;
        reader.missing("model.G",
                       fmt::format("0 is standard NOPD, some of whose short waves no side absorbs; "
                                   "{:.2g} makes the dispersion of long S waves least at this "
                                   "radius, nu and influence, {:.2g} that of P waves",
                                   G_of_least_dispersion(undamped, false),
                                   G_of_least_dispersion(undamped, true)));
    }
    return *G;
}

/// The family, its material and G, which the runtime knows how to refuse.
void read_model(SceneReader& reader, PlaneScene& scene) {
    const std::string family = reader.text("model.family").value_or("nopd2d");
    if (family != "nopd2d" && family != "bond2d") {
        reader.fail(
            "model.family",
            R"(must be "nopd2d" or "bond2d" where domain.nodes is [nx, ny], not ")" + family + '"');
    }
    if (reader.has("model.horizon")) {
        reader.fail("model.horizon",
                    "is of a chain; a plane has model.radius2, its square in dX^2");
    }
    scene.radius_squared = unsigned(reader.required(
        "model.radius2", reader.whole_number("model.radius2", 1, nmbcgen::largest_radius_squared)));
    if (family == "bond2d") {
        return read_bonds(reader, scene);
    }
    for (const char* const key : {"model.alpha", "model.weights"}) {
        if (reader.has(key)) {
            reader.fail(key, "does not count for \"nopd2d\"");
        }
    }
    scene.nu = reader.required("model.nu", read_signed(reader, "model.nu"));
    scene.state =
        read_choice<nmbc::StressState>(reader, "model.state",
                                       {{"plane stress", nmbc::StressState::plane_stress},
                                        {"plane strain", nmbc::StressState::plane_strain}})
            .value_or(nmbc::StressState::plane_stress);
    if (const double nu = nmbcgen::nearest_double(scene.nu); !(nu > -1 && nu < 0.5)) {
        reader.fail("model.nu",
                    fmt::format("does not fit: Poisson's ratio must be between -1 and 1/2, as of "
                                "any isotropic solid, not {}",
                                nu));
    }
    scene.tau = read_signed(reader, "model.damping").value_or(0);
    try {
        nmbc::detail::require_radius(scene.radius_squared);
    } catch (const std::invalid_argument& error) {
        reader.fail("model.radius2", fmt::format("does not fit: {}", error.what()));
    }
    scene.influence = read_plane_influence(reader, scene.radius_squared);
    scene.G = read_plane_G(reader, scene);
    try {
        nopd2d_of(scene);
    } catch (const std::invalid_argument& error) {
        reader.fail("model", fmt::format("is no material: {}", error.what()));
    }
}

/// Throws where a rectangle has no node of the plane in it.
void require_nodes_within(const SceneReader& reader, const std::string& key,
                          const PlaneScene& scene, const std::array<double, 4>& rectangle) {
    for (const std::size_t axis : {0U, 1U}) {
        const auto last = double(scene.nodes[axis]);
        constexpr double roundings = 1e-9;
        if (rectangle[axis] > rectangle[axis + 2]) {
            reader.fail(key, fmt::format("has [{}], whose first point is not the lower left one",
                                         fmt::join(rectangle, ", ")));
        }
        const double low = std::ceil(rectangle[axis] / scene.spacing - roundings);
        const double high = std::floor(rectangle[axis + 2] / scene.spacing + roundings);
        if (!(std::max(low, 1.0) <= std::min(high, last))) {
            reader.fail(key, fmt::format("has [{}], which holds no node: they are at {:g} to {:g} "
                                         "along {}",
                                         fmt::join(rectangle, ", "), scene.spacing,
                                         last * scene.spacing, axis == 0 ? 'x' : 'y'));
        }
    }
}

void read_fracture(SceneReader& reader, PlaneScene& scene) {
    if (!reader.has("fracture")) {
        return;
    }
    PlaneFracture fracture;
    fracture.critical_stretch = reader.number("fracture.critical_stretch", positive);
    fracture.energy = reader.number("fracture.energy", positive);
    fracture.cracks = reader.segments("fracture.cracks");
    fracture.kept = reader.segments("fracture.keep");
    fracture.allow_unstable = reader.truth("fracture.allow_unstable").value_or(false);
    if (!scene.is_bond_based()) {
        reader.fail("fracture", "needs bonds that can break: model.family = \"bond2d\"");
    }
    if (fracture.energy && !(nmbc::fracture_energy(bonds_of(scene), 1) > 0)) {
        reader.fail("fracture.energy",
                    "has no meaning for this lattice: with its weights below 0, "
                    "a crack would set energy free. Give critical_stretch");
    }
    if (fracture.critical_stretch && fracture.energy) {
        reader.fail("fracture.energy", "and fracture.critical_stretch say the same: give one");
    }
    if (!fracture.critical_stretch && !fracture.energy && fracture.cracks.empty()) {
        reader.fail("fracture", "needs critical_stretch, energy or cracks");
    }
    for (const auto& crack : fracture.cracks) {
        if (crack[0] == crack[2] && crack[1] == crack[3]) {
            reader.fail("fracture.cracks", "has a line from a point to itself");
        }
        for (const std::size_t axis : {0U, 1U}) {
            const double last = (double(scene.nodes[axis]) + 0.5) * scene.spacing;
            const double first = scene.spacing / 2;
            if (std::max(crack[axis], crack[axis + 2]) < first ||
                std::min(crack[axis], crack[axis + 2]) > last) {
                reader.fail(
                    "fracture.cracks",
                    fmt::format("has [{}], which is outside of the plane: from {:g} to "
                                "{:g} along {}",
                                fmt::join(crack, ", "), first, last, axis == 0 ? 'x' : 'y'));
            }
        }
    }
    for (const auto& rectangle : fracture.kept) {
        require_nodes_within(reader, "fracture.keep", scene, rectangle);
    }
    scene.fracture = fracture;
}

/// The nodes nearest to the points.
std::vector<std::array<std::size_t, 2>> read_plane_probes(SceneReader& reader,
                                                          const PlaneScene& scene) {
    std::vector<std::array<std::size_t, 2>> probes;
    for (const std::array<double, 2>& point : reader.pairs("output.probes")) {
        std::array<std::size_t, 2> node{};
        for (const std::size_t axis : {0U, 1U}) {
            const double place = std::round(point[axis] / scene.spacing);
            if (!(place >= 1 && place <= double(scene.nodes[axis]))) {
                reader.fail_beside(
                    "output.probes", "domain.nodes",
                    fmt::format("has [{}, {}], but the nodes are at {} to {} along {}", point[0],
                                point[1], scene.spacing, double(scene.nodes[axis]) * scene.spacing,
                                axis == 0 ? 'x' : 'y'));
            }
            node[axis] = std::size_t(place) - 1;
        }
        probes.push_back(node);
    }
    return probes;
}

}  // namespace

bool PlaneScene::has(SideKind kind) const {
    return std::ranges::any_of(sides,
                               [kind](const PlaneSideChoice& side) { return side.kind == kind; });
}

bool PlaneScene::may_grow() const {
    return std::ranges::any_of(
        sides, [](const PlaneSideChoice& side) { return nmbcrun::may_grow(side.kind); });
}

std::vector<std::filesystem::path> inputs_of(const PlaneScene& scene) {
    std::vector<std::filesystem::path> files;
    if (scene.initial) {
        files.push_back(scene.initial->file);
    }
    if (scene.force) {
        files.push_back(scene.force->history.file);
    }
    for (const PlaneLoad& load : scene.loads) {
        files.push_back(load.file);
    }
    std::erase(files, std::filesystem::path());
    return files;
}

bool has_open_layer(const PlaneScene& scene) {
    return std::ranges::any_of(scene.sides, [](const PlaneSideChoice& side) {
        return side.kind == SideKind::extended && side.layer == 0;
    });
}

bool is_plane_scene(const std::string& text, const std::string& path, const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    return reader.is_list("domain.nodes") || reader.has("model.radius2");
}

PlaneScene read_plane_scene(const std::string& text, const std::string& path,
                            const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    reader.refuse_other_tables({"title", "model", "material", "domain", "boundary", "boundary.left",
                                "boundary.right", "boundary.bottom", "boundary.top", "time",
                                "output", "initial", "force", "drive", "load", "fracture"});
    PlaneScene scene;
    read_title(reader, path, scene);
    read_model(reader, scene);
    read_material(reader, scene);
    const auto nodes = reader.required("domain.nodes", reader.pair("domain.nodes", positive));
    for (const std::size_t axis : {0U, 1U}) {
        if (nodes[axis] != std::floor(nodes[axis]) || nodes[0] * nodes[1] > double(most_nodes)) {
            reader.fail("domain.nodes",
                        fmt::format("must be [nx, ny], two whole numbers whose product is at most "
                                    "{}, not [{}, {}]",
                                    most_nodes, nodes[0], nodes[1]));
        }
        scene.nodes[axis] = std::size_t(nodes[axis]);
    }
    scene.spacing = reader.number("domain.spacing", positive).value_or(scene.spacing);
    scene.end = reader.required("time.end", reader.number("time.end", positive));
    read_plane_sides(reader, scene);
    read_plane_sources(reader, path, scene);
    read_fracture(reader, scene);
    scene.field = scene.fracture.has_value();
    read_output(reader, scene);
    scene.field_format =
        read_choice<FieldFormat>(reader, "output.format",
                                 {{"vtk", FieldFormat::vtk}, {"hdf5", FieldFormat::hdf5}})
            .value_or(scene.field_format);
    scene.probes = read_plane_probes(reader, scene);
    read_step(reader, scene);
    require_plane_sources_inside(reader, scene);
    return scene;
}

}  // namespace nmbcrun
